package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Arrays;
import java.util.List;
import java.util.Random;

/**
 * Balls that are thrown, of which the camera tells late: what it tells at first is of no flight.
 */
@Tag("whole-search")
class LateFlightTest {
    private static final double GRAVITY = 9.80665;
    private static final double DELAY = 0.2;
    private static final double SPACING = 0.04;
    private static final int ROWS = 50;
    private static final double NOISE = 0.01;
    private static final double OF_PLACES = 0.05;
    private static final double OF_VELOCITIES = 0.3;

    private static Vec3 normal(Random random, double deviation) {
        return new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
                .times(deviation);
    }

    /**
     * A parabola.
     *
     * @param isHeld whether the ball is at rest before it is thrown, or else on the same parabola
     */
    private static MeasuredRun run(long seed, boolean isHeld) {
        Random random = new Random(seed);
        Vec3 velocity =
                new Vec3(
                        random.nextDouble(5, 10),
                        random.nextDouble(-4, 4),
                        random.nextDouble(7, 12));
        MeasuredRunBuilder run = MeasuredRun.named("throw " + seed);
        for (int k = 0; k < ROWS; k++) {
            double then = k * SPACING - DELAY;
            double t = isHeld ? Math.max(0, then) : then;
            Vec3 place =
                    velocity.times(t)
                            .minus(new Vec3(0, 0, GRAVITY * t * t / 2))
                            .plus(normal(random, NOISE));
            run.at(k * SPACING).position(place.x(), place.y(), place.z());
        }
        Double[] deviations = new Double[RigidMotion.SIZE];
        Arrays.fill(deviations, Double.POSITIVE_INFINITY);
        Arrays.fill(deviations, 0, 3, OF_PLACES);
        Arrays.fill(deviations, 6, 9, OF_VELOCITIES);
        RigidMotion stated =
                new RigidMotion(
                        normal(random, OF_PLACES),
                        Quat.IDENTITY,
                        velocity.plus(normal(random, OF_VELOCITIES)),
                        Vec3.ZERO);
        return run.start(new KnownStart(stated, List.of(deviations))).build();
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void isToldWhateverWasBeforeTheThrow(boolean isHeld) throws Exception {
        BelievedModel model =
                Believed.model(
                        """
                        <scenario><time-step delta="0.02"/>
                          <world-object name="ball" mass="0.5"><sphere radius="0.1"/><gravity/>
                          </world-object>
                        </scenario>
                        """,
                        "ball");
        List<MeasuredRun> fit = List.of(run(1, isHeld), run(2, isHeld), run(3, isHeld));
        List<String> some =
                List.of(
                        "sensor_delay",
                        "impulse",
                        "position_drift",
                        "linear_drag",
                        "sensor_offset");

        Diagnosis diagnosis =
                new Investigation(
                                model,
                                fit,
                                List.of(run(4, isHeld)),
                                Library.named(some, Library.of(model, fit)),
                                1,
                                Progress.SILENT)
                        .diagnose();

        assertThat(diagnosis.selected()).extracting(Finding::cause).containsExactly("sensor_delay");
        assertThat(diagnosis.selected().getFirst().quantities().getFirst().value())
                .isCloseTo(DELAY, within(0.008));
        assertThat(diagnosis.prediction().usedHeldOut()).isFalse();
    }
}
