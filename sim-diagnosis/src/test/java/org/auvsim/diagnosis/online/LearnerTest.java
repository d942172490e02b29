package org.auvsim.diagnosis.online;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.world.World;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.Method;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.simulator.StepMade;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.DoublePredicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** When a learner diagnoses what, whatever becomes of it; feedback comes once a second. */
@Timeout(60)
class LearnerTest {
    private static final LearningPlan PLAN = new LearningPlan(false, 30, 100, 1, Method.SHOOTING);

    private final World world = Heard.world();
    private final BlockingQueue<Investigation> investigations = new LinkedBlockingQueue<>();
    private volatile CountDownLatch gate = new CountDownLatch(0);
    private final Learner learner =
            new Learner(1, Belief.of(world, 1), PLAN, _ -> List.of(), this::diagnosis);

    /** There is none: a fault of each, as soon as that may be. */
    private Diagnosis diagnosis(Investigation of) {
        investigations.add(of);
        try {
            gate.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        throw new UnsupportedOperationException("it is at fault");
    }

    @AfterEach
    void close() {
        learner.close();
    }

    /** A step with a measurement at its end. */
    private void step(Runnable read) {
        world.advanceTimestep();
        double now = world.time();
        measure(new Heard.Positioned(now, Heard.feedback(now).position(), read));
        learner.stepMade(new StepMade(0, Math.round(now), world));
    }

    private void measure(Heard.Positioned feedback) {
        learner.corrected(feedback, Heard.applied(feedback));
    }

    private void steps(int count) {
        for (int i = 0; i < count; i++) {
            step(() -> {});
        }
    }

    /** What is diagnosed next. */
    private List<MeasuredRun> diagnosed() throws InterruptedException {
        Investigation next = investigations.poll(30, TimeUnit.SECONDS);
        assertThat(next).as("a diagnosis").isNotNull();
        return Stream.concat(next.fit().stream(), next.heldOut().stream()).toList();
    }

    private static int samples(List<MeasuredRun> runs) {
        return runs.stream().mapToInt(MeasuredRun::size).sum();
    }

    @Test
    void whatIsTooShortToBeSplitIsWaitedFor() throws Exception {
        CountDownLatch read = new CountDownLatch(1);
        steps(30);
        step(read::countDown);
        assertThat(read.await(30, TimeUnit.SECONDS)).as("31 samples are looked at").isTrue();

        steps(17);

        assertThat(samples(diagnosed())).isEqualTo(48);
    }

    @Test
    void aFaultOfADiagnosisDoesNotEndLearning() throws Exception {
        steps(48);
        assertThat(samples(diagnosed())).isEqualTo(48);

        steps(30);

        assertThat(samples(diagnosed())).isEqualTo(78);
    }

    @Test
    void aCommandThatWasNotHeardIsToldAnew() throws Exception {
        gate = new CountDownLatch(1);
        steps(48);
        diagnosed();
        steps(Learner.MOST_WAITING);
        double commanded = world.time();
        world.object(1).command(Propulsor.class, "screw", 0.5);
        steps(1);
        gate.countDown();
        diagnosed();

        steps(48);

        List<MeasuredRun> runs = diagnosed();
        assertThat(runs).hasSize(2);
        assertThat(levels(runs, time -> time <= commanded)).containsOnly(0.0);
        assertThat(levels(runs, time -> time > commanded)).containsOnly(0.5);
    }

    private static List<Double> levels(List<MeasuredRun> runs, DoublePredicate when) {
        return runs.stream()
                .flatMap(
                        run ->
                                IntStream.range(0, run.size())
                                        .filter(k -> when.test(run.time(k)))
                                        .mapToObj(k -> run.commands().getFirst().level(k)))
                .toList();
    }
}
