package org.auvsim.core.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.sensor.DepthReading;
import org.auvsim.core.sensor.DepthSensor;
import org.auvsim.core.sensor.Sampling;
import org.auvsim.core.sensor.ScalarErrors;
import org.auvsim.core.step.Lanes;
import org.auvsim.core.step.SnapshotStepper;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.IntConsumer;

/** When sensors measure, when their readings arrive, and that nothing else changes them. */
class SensingTest {
    private static final ScalarErrors NOISY = new ScalarErrors(0.1, 0.02, 0.05);

    private static DepthSensor depth(String name, ScalarErrors errors, Sampling sampling) {
        return new DepthSensor(name, Vec3.ZERO, 0, 1025, 1025, errors, sampling);
    }

    private static WorldObjectDefinition.Builder sinking(String name) {
        return Balls.ball(name).velocity(0, 0, -1).effect(new Gravity(2));
    }

    /** Depth of what sinks so, at a time. */
    private static double exact(double t) {
        return t + t * t;
    }

    private static World world(Sampling sampling, ScalarErrors errors) {
        return World.builder()
                .add(sinking("Ball").component(depth("depth", errors, sampling)).build())
                .build();
    }

    private static List<WorldEvent.SensorRead> readings(World world, int steps) {
        return readings(world, w -> advance(w, steps));
    }

    private static List<WorldEvent.SensorRead> readings(World world, Consumer<World> run) {
        List<WorldEvent.SensorRead> heard = new ArrayList<>();
        WorldListener listener =
                event -> {
                    if (event instanceof WorldEvent.SensorRead read) {
                        heard.add(read);
                    }
                };
        world.addListener(listener);
        run.accept(world);
        world.removeListener(listener);
        return heard;
    }

    private static void advance(World world, int steps) {
        for (int i = 0; i < steps; i++) {
            world.advanceTimestep();
        }
    }

    private static double depth(WorldEvent.SensorRead read) {
        return ((DepthReading) read.reading()).depth();
    }

    @Test
    void itMeasuresAtItsOwnInstantsWhateverTheSteps() {
        List<WorldEvent.SensorRead> heard = readings(world(Sampling.at(30), ScalarErrors.NONE), 20);

        assertThat(heard).hasSize(30);
        for (int k = 1; k <= heard.size(); k++) {
            WorldEvent.SensorRead read = heard.get(k - 1);
            assertThat(read.measuredAt()).isEqualTo(k / 30.0);
            assertThat(read.time()).isEqualTo(read.measuredAt());
            assertThat(read.objectId()).isEqualTo(1);
            assertThat(read.sensor()).isEqualTo("depth");
            assertThat(depth(read)).isCloseTo(exact(k / 30.0), within(1e-12));
        }
    }

    @Test
    void aSlowSensorSkipsSteps() {
        assertThat(readings(world(Sampling.at(2), ScalarErrors.NONE), 41))
                .extracting(WorldEvent.SensorRead::measuredAt)
                .containsExactly(0.5, 1.0, 1.5, 2.0);
    }

    @Test
    void instantsCountFromTime0EvenIfTheWorldBeginsLater() {
        World world =
                World.builder()
                        .startTime(100.03)
                        .add(
                                sinking("Ball")
                                        .component(
                                                depth("depth", ScalarErrors.NONE, Sampling.at(10)))
                                        .build())
                        .build();

        assertThat(readings(world, 4))
                .extracting(WorldEvent.SensorRead::measuredAt)
                .containsExactly(100.1, 100.2);
    }

    @Test
    void aDelayedReadingArrivesLaterAndSaysWhenItWasTrue() {
        List<WorldEvent.SensorRead> heard =
                readings(world(new Sampling(10, 0.17, 0, 0), ScalarErrors.NONE), 10);

        assertThat(heard)
                .extracting(WorldEvent.SensorRead::measuredAt)
                .containsExactly(0.1, 0.2, 0.3);
        for (WorldEvent.SensorRead read : heard) {
            assertThat(read.time()).isCloseTo(read.measuredAt() + 0.17, within(1e-12));
            assertThat(depth(read)).isCloseTo(exact(read.measuredAt()), within(1e-12));
        }
    }

    @Test
    void readingsComeInOrderOfArrivalBeforeTheMovementsOfTheStep() {
        List<String> order = new ArrayList<>();
        World world =
                World.builder()
                        .add(sinking("A").component(depth("slow", NOISY, Sampling.at(20))).build())
                        .add(
                                sinking("B")
                                        .position(9, 0, 0)
                                        .component(depth("fast", NOISY, Sampling.at(40)))
                                        .build())
                        .build();
        world.addListener(
                event ->
                        order.add(
                                event instanceof WorldEvent.SensorRead read
                                        ? read.sensor() + " " + read.time()
                                        : event.getClass().getSimpleName()));
        world.advanceTimestep();

        assertThat(order)
                .containsExactly(
                        "fast 0.025", "slow 0.05", "fast 0.05", "Moved", "Moved", "StepAdvanced");
    }

    @Test
    void theShareOfDropoutsIsLost() {
        int all = 4000;
        int lost = all - readings(world(new Sampling(200, 0, 0.3, 5), NOISY), all / 10).size();

        assertThat(lost / (double) all).isCloseTo(0.3, within(5 * Math.sqrt(0.3 * 0.7 / all)));
    }

    @Test
    void aRunIsRepeatedBitForBitAndAnotherSeedIsAnotherRun() {
        Sampling sampling = new Sampling(25, 0.08, 0.1, 3);
        List<WorldEvent.SensorRead> heard = readings(world(sampling, NOISY), 100);

        assertThat(heard).isNotEmpty();
        assertThat(readings(world(sampling, NOISY), 100)).isEqualTo(heard);
        assertThat(readings(world(new Sampling(25, 0.08, 0.1, 4), NOISY), 100)).isNotEqualTo(heard);
    }

    @Test
    void aCopyInMidRunReadsOnAsTheOriginal() {
        for (int before = 0; before < 8; before++) {
            World world = world(new Sampling(25, 0.11, 0.1, 3), NOISY);
            advance(world, before);
            World copy = world.copy();

            List<WorldEvent.SensorRead> heard = readings(world, 40);
            assertThat(readings(copy, 40)).isNotEmpty().isEqualTo(heard);
        }
    }

    @Test
    void whoListensLaterHearsTheSame() {
        Sampling sampling = new Sampling(25, 0.11, 0.1, 3);
        List<WorldEvent.SensorRead> heard = readings(world(sampling, NOISY), 60);
        World unheard = world(sampling, NOISY);
        advance(unheard, 20);

        assertThat(readings(unheard, 40))
                .isEqualTo(heard.stream().filter(read -> read.time() > 1 + 1e-9).toList());
    }

    @Test
    void anObjectThatLeavesReadsNoMore() {
        World world = world(new Sampling(20, 0.2, 0, 0), NOISY);
        advance(world, 3);
        world.remove(1);

        assertThat(readings(world, 20)).isEmpty();
    }

    @Test
    void aSensorThatComesLaterMeasuresFromThenOn() {
        World world = World.builder().add(sinking("Ball").build()).build();
        advance(world, 3);
        world.object("Ball").add(depth("depth", ScalarErrors.NONE, Sampling.at(10)));

        assertThat(readings(world, 4))
                .extracting(WorldEvent.SensorRead::measuredAt)
                .containsExactly(0.2, 0.3);
        world.object("Ball").remove("depth");
        assertThat(readings(world, 4)).isEmpty();
    }

    @Test
    void theSnapshotStepperLetsThemMeasureToo() {
        World world =
                World.builder()
                        .stepper(SnapshotStepper.standard())
                        .add(
                                sinking("Ball")
                                        .component(
                                                depth("depth", ScalarErrors.NONE, Sampling.at(30)))
                                        .build())
                        .build();

        assertThat(readings(world, 20)).hasSize(30);
    }

    /** 600 bodies, more than a single lane is kept for, each with a sensor. */
    private static World shoal(Lanes lanes) {
        WorldBuilder world = World.builder().lanes(lanes);
        for (int i = 0; i < 600; i++) {
            world.add(
                    sinking("Fish " + i)
                            .position(2 * (i % 25), 2 * (i / 25 % 24), 0)
                            .component(depth("depth", NOISY, new Sampling(30, 0.03, 0.1, 5)))
                            .build());
        }
        return world.build();
    }

    @ParameterizedTest(name = "{0} lanes")
    @ValueSource(ints = {2, 3})
    void lanesReadTheSame(int count) {
        Lanes backward =
                new Lanes() {
                    @Override
                    public int count() {
                        return count;
                    }

                    @Override
                    public void run(IntConsumer part) {
                        for (int i = count - 1; i >= 0; i--) {
                            part.accept(i);
                        }
                    }
                };

        assertThat(readings(shoal(backward), 6))
                .isNotEmpty()
                .isEqualTo(readings(shoal(Lanes.ONE), 6));
    }
}
