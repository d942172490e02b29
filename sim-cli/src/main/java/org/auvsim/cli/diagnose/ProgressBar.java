package org.auvsim.cli.diagnose;

import org.auvsim.diagnosis.fit.Progress;

import java.io.PrintWriter;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;

/**
 * Shows how far a diagnosis is: at a terminal as a bar that grows in its line, elsewhere as a line
 * for each stage and each twentieth of the way, two seconds apart at least. A log of a search that
 * takes hours is then as long as one of minutes.
 */
public final class ProgressBar implements Progress, AutoCloseable {
    private static final int WIDTH = 30;
    private static final long EVERY_LINE = 2_000_000_000L;
    private static final long EVERY_FRAME = 100_000_000L;
    private static final int EVERY_PERCENT = 5;

    private final PrintWriter out;
    private final boolean isTerminal;
    private final LongSupplier nanos;
    private final BooleanSupplier stop;
    private long next;
    private int drawn;
    private final Set<String> said = new HashSet<>();
    private long saidTo = -EVERY_PERCENT;

    /**
     * A bar that begins now.
     *
     * @param isTerminal whether a line can be written over
     * @param nanos a clock
     * @param stop whether the diagnosis is to end with what it has
     */
    public ProgressBar(
            PrintWriter out, boolean isTerminal, LongSupplier nanos, BooleanSupplier stop) {
        this.out = out;
        this.isTerminal = isTerminal;
        this.nanos = nanos;
        this.stop = stop;
        this.next = nanos.getAsLong() + (isTerminal ? 0 : EVERY_LINE);
    }

    @Override
    public boolean at(String stage, double share) {
        long now = nanos.getAsLong();
        if (now - next >= 0 && (isTerminal || isNews(stage, share))) {
            next = now + (isTerminal ? EVERY_FRAME : EVERY_LINE);
            show(stage, Math.max(0, Math.min(1, share)));
        }
        return !stop.getAsBoolean();
    }

    private boolean isNews(String stage, double share) {
        long percent = Math.round(100 * share);
        boolean isNews = !said.contains(stage) || percent >= saidTo + EVERY_PERCENT;
        if (isNews) {
            said.add(stage);
            saidTo = Math.max(saidTo, percent);
        }
        return isNews;
    }

    private void show(String stage, double share) {
        if (isTerminal) {
            int full = (int) Math.round(WIDTH * share);
            draw(
                    String.format(
                            Locale.ROOT,
                            "[%s%s] %3.0f %% %s",
                            "#".repeat(full),
                            ".".repeat(WIDTH - full),
                            100 * share,
                            stage));
        } else {
            out.printf(Locale.ROOT, "%.0f %%: %s%n", 100 * share, stage);
            out.flush();
        }
    }

    private void draw(String line) {
        out.print("\r" + line + " ".repeat(Math.max(0, drawn - line.length())));
        out.flush();
        drawn = line.length();
    }

    /** Takes the bar away. */
    @Override
    public void close() {
        if (drawn > 0) {
            draw("");
            out.print("\r");
            out.flush();
        }
    }
}
