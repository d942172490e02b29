package org.auvsim.junit;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Which file is run, how often, and what a test is told if it cannot be. */
class ReplayScenarioTest {
    @TempDir private Path folder;

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "missing | names none.auvsml.gz, which is neither a resource (relative to its"
                        + " class) nor a file (relative to ",
                "endless | drift.xml is a scenario, which has no end: say"
                        + " @ReplayScenario(value = \"drift.xml\", until = ...).",
                "early | drift.xml begins at 0 s: until must be after that, but is -1 s.",
                "faulty | faulty.xml:4:5: ",
                "stuck | fast.xml cannot be run beyond 0 s: ",
            },
            quoteCharacter = '#')
    void aFileThatCannotBeRunIsExplained(String test, String sentence) {
        assertThat(Tested.method(Unusable.class, test, folder).failure())
                .hasMessageContaining(sentence)
                .message()
                .hasLineCount(1);
    }

    static class Unusable {
        @Test
        @ReplayScenario("none.auvsml.gz")
        void missing(Replay replay) {
            assertThat(replay).isNotNull();
        }

        @Test
        @ReplayScenario("drift.xml")
        void endless(Replay replay) {
            assertThat(replay).isNotNull();
        }

        @Test
        @ReplayScenario(value = "drift.xml", until = -1)
        void early(Replay replay) {
            assertThat(replay).isNotNull();
        }

        @Test
        @ReplayScenario(value = "faulty.xml", until = 1)
        void faulty(Replay replay) {
            assertThat(replay).isNotNull();
        }

        @Test
        @ReplayScenario(value = "fast.xml", until = 1)
        void stuck(Replay replay) {
            assertThat(replay).isNotNull();
        }
    }

    @Test
    void theTestsOfAClassShareOneRunAndAMethodMayHaveItsOwn() {
        Sharing.SEEN.clear();

        assertThat(Tested.all(Sharing.class, folder).succeeded()).isEqualTo(4);

        List<Replay> shared = Sharing.SEEN.stream().filter(r -> r.end() > 1.5).toList();
        assertThat(shared).hasSize(3);
        assertThat(shared)
                .allSatisfy(r -> assertThat(r.scenario()).isSameAs(shared.getFirst().scenario()));
        assertThat(Sharing.SEEN).hasSize(4);
    }

    @ReplayScenario(value = "src/test/resources/org/auvsim/junit/drift.xml", until = 2)
    static class Sharing {
        static final List<Replay> SEEN = new ArrayList<>();

        @Test
        void one(Replay replay) {
            SEEN.add(replay);
        }

        @Test
        void two(Replay replay) {
            SEEN.add(replay);
        }

        @Test
        @ReplayScenario(value = "/org/auvsim/junit/drift.xml", until = 1)
        void shorter(Replay replay) {
            SEEN.add(replay);
        }

        @Nested
        class Within {
            @Test
            void three(Replay replay) {
                SEEN.add(replay);
            }
        }
    }
}
