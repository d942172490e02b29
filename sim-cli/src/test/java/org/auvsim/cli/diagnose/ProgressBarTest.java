package org.auvsim.cli.diagnose;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.concurrent.atomic.AtomicLong;

class ProgressBarTest {
    private static final long SECOND = 1_000_000_000L;

    private final StringWriter out = new StringWriter();
    private final AtomicLong now = new AtomicLong();

    @Test
    void aTerminalSeesABarThatIsTakenAway() {
        try (ProgressBar bar = bar(true, false)) {
            assertThat(bar.at("screening", 0.5)).isTrue();
            now.addAndGet(SECOND);
            bar.at("end", 1);
        }

        assertThat(out.toString())
                .startsWith("\r[###############...............]  50 % screening")
                .contains("\r[##############################] 100 % end      ")
                .endsWith("\r");
    }

    @Test
    void elsewhereALineIsSaidEveryTwoSeconds() {
        try (ProgressBar bar = bar(false, false)) {
            bar.at("screening", 0.1);
            now.addAndGet(2 * SECOND);
            bar.at("screening", 0.2);
            now.addAndGet(SECOND);
            bar.at("refining", 0.3);
        }

        assertThat(out.toString().lines()).containsExactly("20 %: screening");
    }

    @Test
    void elsewhereNothingIsSaidTwice() {
        try (ProgressBar bar = bar(false, false)) {
            for (int second = 0; second < 3600; second++) {
                now.addAndGet(SECOND);
                bar.at(second % 2 == 0 ? "fitting" : "screening", 0.1);
            }
            now.addAndGet(SECOND);
            bar.at("fitting", 0.14);
            bar.at("fitting", 0.15);
        }

        assertThat(out.toString().lines())
                .containsExactly("10 %: screening", "10 %: fitting", "15 %: fitting");
    }

    /** However long it takes. */
    @Test
    void elsewhereThereAreTwentyLinesAndOneForEachStage() {
        try (ProgressBar bar = bar(false, false)) {
            for (int step = 0; step <= 10_000; step++) {
                now.addAndGet(10 * SECOND);
                bar.at(step < 5000 ? "screening" : "fitting", step / 10_000.0);
            }
        }

        assertThat(out.toString().lines())
                .hasSizeLessThanOrEqualTo(22)
                .doesNotHaveDuplicates()
                .contains("50 %: fitting");
    }

    @Test
    void theSearchIsToldToStop() {
        try (ProgressBar bar = bar(false, true)) {
            assertThat(bar.at("screening", 0.1)).isFalse();
        }
    }

    private ProgressBar bar(boolean isTerminal, boolean stops) {
        return new ProgressBar(new PrintWriter(out), isTerminal, now::get, () -> stops);
    }
}
