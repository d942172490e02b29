package org.auvsim.core.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;

class ImuTest {
    private static final double G = 9.80665;

    private static Imu imu(Vec3 position, Quat orientation, double rate) {
        return new Imu(
                "imu",
                position,
                orientation,
                G,
                InertialErrors.NONE,
                InertialErrors.NONE,
                Sampling.at(rate));
    }

    private static List<ImuReading> readings(WorldObjectDefinition.Builder body, double time) {
        World world = World.builder().add(body.build()).build();
        return Bench.readings(world, ImuReading.class, time);
    }

    private static void assertClose(Vec3 actual, Vec3 expected, double tolerance) {
        assertThat(actual.distance(expected)).as("%s", actual).isLessThan(tolerance);
    }

    @Test
    void atRestItFeelsWhatHoldsItUp() {
        Quat mounted = Bench.pitch(0.3);
        ImuReading reading = readings(Bench.ball(imu(Vec3.ZERO, mounted, 20)), 0.05).getFirst();

        assertClose(reading.angularRate(), Vec3.ZERO, 1e-15);
        assertClose(
                reading.specificForce(), new Vec3(-G * Math.sin(0.3), 0, G * Math.cos(0.3)), 1e-14);
    }

    @Test
    void inFreeFallItFeelsNothing() {
        WorldObjectDefinition.Builder falling =
                Bench.ball(imu(Vec3.ZERO, Quat.IDENTITY, 8)).effect(new Gravity(G));

        for (ImuReading reading : readings(falling, 2)) {
            assertClose(reading.specificForce(), Vec3.ZERO, 1e-12);
        }
    }

    /**
     * Off the axis of a turn at a constant rate w the acceleration is w^2 r inward; its mean over a
     * turn by angle a, seen in the axes halfway, is shorter by sin(a/2) / (a/2).
     */
    @ParameterizedTest(name = "{0} Hz")
    @ValueSource(doubles = {4, 15, 20, 60})
    void offTheAxisOfATurnItIsPulledOutward(double rate) {
        double w = 2;
        WorldObjectDefinition.Builder turning =
                Bench.ball(imu(new Vec3(0.4, 0, 0), Quat.IDENTITY, rate)).angularVelocity(0, 0, w);
        double half = w / rate / 2;
        Vec3 expected = new Vec3(-w * w * 0.4 * Math.sin(half) / half, 0, G);

        List<ImuReading> readings = readings(turning, 2);
        assertThat(readings).hasSize((int) (2 * rate));
        for (ImuReading reading : readings) {
            assertClose(reading.angularRate(), new Vec3(0, 0, w), 1e-4);
            assertClose(reading.specificForce(), expected, 1e-3);
        }
    }

    @Test
    void ratesAreInItsOwnAxes() {
        Quat mounted = Bench.yaw(Math.PI / 2);
        WorldObjectDefinition.Builder turning =
                Bench.ball(imu(Vec3.ZERO, mounted, 20)).angularVelocity(0.5, 0, 0);

        for (ImuReading reading : readings(turning, 1)) {
            assertClose(reading.angularRate(), new Vec3(0, -0.5, 0), 1e-7);
        }
    }

    @Test
    void theIncrementsAddUpToTheChangeOfVelocityThroughACollision() {
        WorldObjectDefinition.Builder ball =
                Bench.ball(imu(Vec3.ZERO, Quat.IDENTITY, 50)).velocity(2, 0, 0);
        World world =
                World.builder()
                        .add(ball.build())
                        .add(
                                WorldObjectDefinition.named("Wall")
                                        .fixed()
                                        .volume(new Box(new Vec3(1, 9, 9)))
                                        .position(2, 0, 0)
                                        .build())
                        .build();

        List<ImuReading> readings = Bench.readings(world, ImuReading.class, 2);

        double gained = readings.stream().mapToDouble(r -> r.specificForce().x() / 50).sum();
        assertThat(gained).isCloseTo(-4, within(1e-9));
        assertThat(readings.stream().filter(r -> Math.abs(r.specificForce().x()) > 1)).isNotEmpty();
    }

    /** A unit at rest whose gyroscope has errors along x, without a world. */
    private static double[] ratesAtRest(InertialErrors errors, double rate, int count) {
        Imu imu =
                new Imu(
                        "imu",
                        Vec3.ZERO,
                        Quat.IDENTITY,
                        G,
                        errors,
                        InertialErrors.NONE,
                        new Sampling(rate, 0, 0, 11));
        double[] rates = new double[count];
        for (int k = 1; k <= count; k++) {
            Noise noise = Noise.of(1, "imu", imu.sampling(), k);
            Sample sample =
                    new Sample(rest(k / rate), rest((k - 1) / rate), new StillScene(), noise);
            rates[k - 1] = ((ImuReading) imu.read(sample).orElseThrow()).angularRate().x();
        }
        return rates;
    }

    private static Kinematics rest(double time) {
        return new Kinematics(time, Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);
    }

    /** Half the mean square difference of neighbouring means over {@code n} readings. */
    private static double allanVariance(double[] rates, int n) {
        int clusters = rates.length / n;
        double[] means = new double[clusters];
        for (int c = 0; c < clusters; c++) {
            for (int i = 0; i < n; i++) {
                means[c] += rates[c * n + i] / n;
            }
        }
        double sum = 0;
        for (int c = 1; c < clusters; c++) {
            sum += (means[c] - means[c - 1]) * (means[c] - means[c - 1]);
        }
        return sum / (2 * (clusters - 1));
    }

    /** Of M clusters the Allan variance errs by about sqrt(3 / M): five of these. */
    private static double bound(double rate, double tau, int count) {
        return 5 * Math.sqrt(3 * tau * rate / count);
    }

    @Test
    void theAllanVarianceOfItsNoiseIsTheDensitySquaredOverTime() {
        double density = 2e-4;
        double[] rates =
                ratesAtRest(
                        new InertialErrors(new Vec3(density, 0, 0), Vec3.ZERO, Vec3.ZERO),
                        100,
                        100_000);

        for (double tau : new double[] {0.01, 0.1, 1}) {
            double expected = density * density / tau;
            assertThat(allanVariance(rates, (int) Math.round(tau * 100)) / expected)
                    .as("at %s s", tau)
                    .isCloseTo(1, within(bound(100, tau, rates.length)));
        }
    }

    @Test
    void theAllanVarianceOfItsDriftIsTheRandomWalkSquaredTimesAThirdOfTime() {
        double walk = 3e-5;
        double[] rates =
                ratesAtRest(
                        new InertialErrors(Vec3.ZERO, new Vec3(0.1, 0, 0), new Vec3(walk, 0, 0)),
                        20,
                        60_000);

        for (double tau : new double[] {1, 4}) {
            double expected = walk * walk * tau / 3;
            assertThat(allanVariance(rates, (int) Math.round(tau * 20)) / expected)
                    .as("at %s s", tau)
                    .isCloseTo(1, within(bound(20, tau, rates.length)));
        }
    }
}
