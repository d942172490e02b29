package org.auvsim.diagnosis.online;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;

/** What is told of an object, by a bounded queue. */
class WatcherTest {
    private static final int MOST = 4;

    private final World world = Heard.world();
    private final BlockingQueue<Observation> queue = new ArrayBlockingQueue<>(MOST);
    private final Watcher watcher = new Watcher(1, queue::offer);

    /** A step with a measurement at its end. */
    private void step() {
        world.advanceTimestep();
        watch();
    }

    private void watch() {
        Heard.Positioned feedback = Heard.feedback(world.time());
        watcher.corrected(Heard.applied(feedback));
        watcher.stepMade(world);
    }

    private void command(double level) {
        world.object(1).command(Propulsor.class, "screw", level);
    }

    /** Takes all out of the queue. */
    private List<String> heard() {
        List<Observation> all = new ArrayList<>();
        queue.drainTo(all);
        return all.stream().map(WatcherTest::text).toList();
    }

    private static String text(Observation observation) {
        return switch (observation) {
            case Observation.Told told -> told.time() + " told " + told.levels().get("screw");
            case Observation.Measured measured -> measured.time() + " measured";
            case Observation.Broken _ -> "broken";
        };
    }

    @Test
    void commandsAreToldFromTheBeginningOfTheirStepAndOnlyWhereTheyChange() {
        step();
        assertThat(heard()).containsExactly("1.0 measured");

        step();
        assertThat(heard()).containsExactly("1.0 told 0.0", "2.0 measured");

        step();
        command(0.5);
        step();
        assertThat(heard()).containsExactly("3.0 measured", "3.0 told 0.5", "4.0 measured");
    }

    @Test
    void aJumpOfTimeIsABreak() {
        World before = world.copy();
        step();
        step();
        step();
        heard();

        world.restore(before);
        step();
        step();

        assertThat(heard())
                .containsExactly("broken", "1.0 measured", "1.0 told 0.0", "2.0 measured");
    }

    @Test
    void afterACommandThatWasNotHeardComeABreakAndTheCommand() {
        step();
        step();
        step();
        command(0.5);
        step();
        step();
        assertThat(heard())
                .containsExactly("1.0 measured", "1.0 told 0.0", "2.0 measured", "3.0 measured");

        step();
        step();

        assertThat(heard())
                .containsExactly("broken", "5.0 told 0.5", "6.0 measured", "7.0 measured");
    }

    @Test
    void nothingIsHeardUntilTheBreakIs() {
        for (int i = 0; i < 10; i++) {
            step();
            command(0.1 * (i % 2));
        }
        heard();

        step();

        assertThat(heard()).containsExactly("broken", "10.0 told 0.1", "11.0 measured");
    }

    @Test
    void ofAStepThatIsHeardInPartTheRestIsLeftOut() {
        queue.add(new Observation.Broken());
        queue.add(new Observation.Broken());
        step();
        command(0.5);
        step();
        heard();

        step();

        assertThat(heard()).containsExactly("broken", "2.0 told 0.5", "3.0 measured");
    }

    @Test
    void aJumpThatWasNotHeardIsToldLater() {
        World before = world.copy();
        step();
        step();
        step();
        world.restore(before);
        step();
        heard();

        step();

        assertThat(heard()).containsExactly("broken", "1.0 told 0.0", "2.0 measured");
    }
}
