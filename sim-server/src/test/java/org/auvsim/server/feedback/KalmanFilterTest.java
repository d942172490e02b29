package org.auvsim.server.feedback;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.apache.commons.math3.filter.DefaultMeasurementModel;
import org.apache.commons.math3.filter.DefaultProcessModel;
import org.apache.commons.math3.filter.KalmanFilter;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.auvsim.auvsml.document.Deviations;
import org.auvsim.auvsml.message.feedback.Covariance;
import org.auvsim.core.effect.Damping;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Optional;
import java.util.Random;

/** What the filter makes of measurements, against filters and statistics from elsewhere. */
class KalmanFilterTest {
    private static final double STEP = FilteredRobot.STEP;
    private static final double DENSITY = 0.3;
    private static final Deviations INITIAL = new Deviations(1, 0.2, 0.5, 0.1);

    private static KalmanFilterFeedbackHandler filter() {
        return new KalmanFilterFeedbackHandler(
                DENSITY, 0.2, new Deviations(0.1, 0.02, 0.05, 0.01), INITIAL);
    }

    private static FilteredRobot drifting() {
        return new FilteredRobot(filter(), FilteredRobot.ball(new Vec3(1, 0, 0), Vec3.ZERO));
    }

    /** The linear filter of Apache Commons Math for position and velocity along one axis. */
    private static KalmanFilter linear(double position, double velocity, double t, double r) {
        double q = DENSITY * DENSITY;
        RealMatrix noise =
                new Array2DRowRealMatrix(
                        new double[][] {
                            {q * t * t * t / 3, q * t * t / 2}, {q * t * t / 2, q * t}
                        });
        RealMatrix initial =
                MatrixUtils.createRealDiagonalMatrix(
                        new double[] {
                            INITIAL.position() * INITIAL.position(),
                            INITIAL.velocity() * INITIAL.velocity()
                        });
        return new KalmanFilter(
                new DefaultProcessModel(
                        new Array2DRowRealMatrix(new double[][] {{1, t}, {0, 1}}),
                        new Array2DRowRealMatrix(new double[][] {{0}, {0}}),
                        noise,
                        new ArrayRealVector(new double[] {position, velocity}),
                        initial),
                new DefaultMeasurementModel(new double[][] {{1, 0}}, new double[][] {{r}}));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void ofAFreeBodyItIsTheLinearFilter(long seed) {
        Random random = new Random(seed);
        FilteredRobot robot = drifting();
        double r = 0.04;
        KalmanFilter x = linear(STEP, 1, STEP, r);
        KalmanFilter y = linear(0, 0, STEP, r);
        for (int k = 1; k <= 100; k++) {
            double time = k * STEP;
            Vec3 measured =
                    new Vec3(
                            1.3 * time + 0.2 * random.nextGaussian(),
                            0.4 - 0.1 * time + 0.2 * random.nextGaussian(),
                            0);
            robot.step.robot(p -> robot.measures(p.time(), measured, Covariance.diagonal(r, r, r)));
            robot.step.advanceTimestep();
            if (k > 1) {
                x.predict();
                y.predict();
            }
            x.correct(new double[] {measured.x()});
            y.correct(new double[] {measured.y()});
            RigidMotion motion = RigidMotion.of(robot.world.object(1));
            assertThat(motion.position().x()).isCloseTo(x.getStateEstimation()[0], within(1e-7));
            assertThat(motion.position().y()).isCloseTo(y.getStateEstimation()[0], within(1e-7));
            assertThat(motion.velocity().x()).isCloseTo(x.getStateEstimation()[1], within(1e-7));
            assertThat(motion.velocity().y()).isCloseTo(y.getStateEstimation()[1], within(1e-7));
        }
        RealMatrix covariance = robot.memories.getLast().covariance();
        RealMatrix expected = x.getErrorCovarianceMatrix();
        assertThat(covariance.getEntry(0, 0)).isCloseTo(expected.getEntry(0, 0), within(1e-8));
        assertThat(covariance.getEntry(0, 6)).isCloseTo(expected.getEntry(0, 1), within(1e-8));
        assertThat(covariance.getEntry(6, 6)).isCloseTo(expected.getEntry(1, 1), within(1e-8));
    }

    /** Ten steps without a measurement are one long one to a filter of a free body. */
    @Test
    void stepsWithoutFeedbackCarryTheErrorOn() {
        FilteredRobot robot = drifting();
        Covariance noise = Covariance.diagonal(0.04, 0.04, 0.04);
        robot.step.robot(
                p -> {
                    if (p.time() < 0.06) {
                        robot.measures(p.time(), new Vec3(0.1, 0, 0), noise);
                    }
                    if (Math.abs(p.time() - 0.55) < 1e-6) {
                        robot.measures(p.time(), new Vec3(0.9, 0, 0), noise);
                    }
                });
        KalmanFilter oracle = linear(STEP, 1, 10 * STEP, 0.04);
        for (int k = 0; k < 11; k++) {
            robot.step.advanceTimestep();
        }
        oracle.correct(new double[] {0.1});
        oracle.predict();
        oracle.correct(new double[] {0.9});
        RigidMotion motion = RigidMotion.of(robot.world.object(1));
        assertThat(robot.memories).hasSize(2);
        assertThat(motion.position().x()).isCloseTo(oracle.getStateEstimation()[0], within(1e-8));
        assertThat(motion.velocity().x()).isCloseTo(oracle.getStateEstimation()[1], within(1e-8));
    }

    /**
     * A ball that spins, driven by the noise that the filter assumes and measured with the noise
     * that it is told: its innovations are as large as it expects. Their sum is chi-squared with 12
     * degrees of freedom each; the bounds are four of its standard deviations.
     */
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4})
    void itIsAsSurprisedAsItExpectsToBe(long seed) {
        Random random = new Random(seed);
        Vec3 spin = new Vec3(0.3, -0.2, 0.5);
        FilteredRobot robot =
                new FilteredRobot(filter(), FilteredRobot.ball(new Vec3(1, 0, 0), spin));
        double[] deviations = {0.05, 0.01, 0.03, 0.02};
        RigidMotion truth =
                RigidMotion.of(robot.world.object(1))
                        .plus(errors(random, new double[] {1, 0.2, 0.5, 0.1}));
        int count = 300;
        for (int k = 0; k < count; k++) {
            truth = driven(truth, random);
            RigidMotion seen = truth.plus(errors(random, deviations));
            robot.step.robot(p -> measure(robot, p.time(), seen, deviations));
            robot.step.advanceTimestep();
        }
        double mean = robot.memories.stream().mapToDouble(FilterMemory::surprise).sum() / count;
        assertThat(mean).isCloseTo(12, within(4 * Math.sqrt(2.0 * 12 / count)));
    }

    private static void measure(
            FilteredRobot robot, double time, RigidMotion seen, double[] deviations) {
        double[] variances = new double[12];
        for (int i = 0; i < 12; i++) {
            variances[i] = deviations[i / 3] * deviations[i / 3];
        }
        robot.measures(
                time,
                Optional.of(seen.position()),
                Optional.of(seen.orientation()),
                Optional.of(seen.velocity()),
                Optional.of(seen.angularVelocity()),
                Optional.of(Covariance.diagonal(variances)));
    }

    private static double[] errors(Random random, double[] deviations) {
        double[] errors = new double[12];
        for (int i = 0; i < 12; i++) {
            errors[i] = deviations[i / 3] * random.nextGaussian();
        }
        return errors;
    }

    /** A step of a free ball with white accelerations: exact but for the order of small turns. */
    private static RigidMotion driven(RigidMotion motion, Random random) {
        double[] way = new double[12];
        double[] before = {
            motion.velocity().x(),
            motion.velocity().y(),
            motion.velocity().z(),
            motion.angularVelocity().x(),
            motion.angularVelocity().y(),
            motion.angularVelocity().z()
        };
        for (int i = 0; i < 6; i++) {
            double density = i < 3 ? DENSITY : 0.2;
            double change = density * Math.sqrt(STEP) * random.nextGaussian();
            double rest = density * Math.sqrt(STEP * STEP * STEP / 12) * random.nextGaussian();
            way[i] = before[i] * STEP + change * STEP / 2 + rest;
            way[6 + i] = change;
        }
        return motion.plus(way);
    }

    @Test
    void aMeasurementThatMayBeFarOffChangesNothing() {
        FilteredRobot robot = drifting();
        robot.step.robot(
                p ->
                        robot.measures(
                                p.time(),
                                new Vec3(5, 5, 5),
                                Covariance.diagonal(1e18, 1e18, 1e18)));
        robot.step.advanceTimestep();
        assertThat(robot.world.object(1).position().distance(new Vec3(STEP, 0, 0)))
                .isLessThan(1e-14);
        assertThat(robot.world.object(1).velocity().distance(new Vec3(1, 0, 0))).isLessThan(1e-14);
    }

    /** All errors are one and the same, and the measurement's are below their rounding. */
    @Test
    void whatCannotBeWeighedIsOneSentence() {
        RigidMotion motion = new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);
        RealMatrix ones = MatrixUtils.createRealMatrix(12, 12).scalarAdd(1);
        Target measured =
                new Target(
                        Optional.of(Vec3.ZERO),
                        Optional.empty(),
                        Optional.empty(),
                        Optional.empty(),
                        Optional.empty());
        RealMatrix exact = MatrixUtils.createRealIdentityMatrix(3).scalarMultiply(1e-30);
        assertThatThrownBy(() -> KalmanUpdate.of(motion, ones, measured, exact))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("cannot be weighed against each other")
                .hasMessageContaining("row 2");
    }

    /** Position and velocity err together after a while: a position tells of the velocity, too. */
    @Test
    void positionsAloneCorrectTheVelocity() {
        FilteredRobot robot = drifting();
        Covariance noise = Covariance.diagonal(1e-4, 1e-4, 1e-4);
        robot.step.robot(p -> robot.measures(p.time(), new Vec3(0, 1.5 * p.time(), 0), noise));
        while (robot.world.time() < 5) {
            robot.step.advanceTimestep();
        }
        assertThat(robot.world.object(1).velocity().distance(new Vec3(0, 1.5, 0))).isLessThan(1e-2);
    }

    /**
     * The transition is that of the step itself: damping of rate 2/s takes e^(-2 dt) of a speed.
     */
    @Test
    void dampingDampsTheErrorsToo() {
        WorldObjectDefinition damped =
                WorldObjectDefinition.named("ball")
                        .id(1)
                        .mass(3)
                        .volume(new Sphere(1))
                        .effect(
                                new Damping(
                                        new Vec3(6, 6, 6),
                                        Vec3.ZERO,
                                        new Vec3(2.4, 2.4, 2.4),
                                        Vec3.ZERO))
                        .build();
        KalmanFilterFeedbackHandler quiet =
                new KalmanFilterFeedbackHandler(0, 0, new Deviations(1, 1, 1, 1), INITIAL);
        FilteredRobot robot = new FilteredRobot(quiet, damped);
        Covariance hardly = Covariance.diagonal(1e12, 1e12, 1e12);
        robot.step.robot(p -> robot.measures(p.time(), Vec3.ZERO, hardly));
        while (robot.world.time() < 1) {
            robot.step.advanceTimestep();
        }
        double share = Math.exp(-2 * (robot.world.time() - STEP));
        RealMatrix covariance = robot.memories.getLast().covariance();
        assertThat(covariance.getEntry(6, 6)).isCloseTo(0.25 * share * share, within(1e-6));
        assertThat(covariance.getEntry(9, 9)).isCloseTo(0.01 * share * share, within(1e-7));
        double way = (1 - share) / 2;
        assertThat(covariance.getEntry(0, 0)).isCloseTo(1 + 0.25 * way * way, within(1e-6));
    }

    /** A body that spins turns its errors: an error of the spin becomes one of the turn. */
    @Test
    void anOrientationCorrectsTheSpin() {
        FilteredRobot robot =
                new FilteredRobot(filter(), FilteredRobot.ball(Vec3.ZERO, new Vec3(0, 0, 0.5)));
        Covariance noise = Covariance.diagonal(1e-6, 1e-6, 1e-6);
        robot.step.robot(
                p ->
                        robot.measures(
                                p.time(),
                                Optional.empty(),
                                Optional.of(Quat.ofAxisAngle(new Vec3(0, 0, 1), 0.6 * p.time())),
                                Optional.empty(),
                                Optional.empty(),
                                Optional.of(noise)));
        while (robot.world.time() < 5) {
            robot.step.advanceTimestep();
        }
        assertThat(robot.world.object(1).angularVelocity().distance(new Vec3(0, 0, 0.6)))
                .isLessThan(1e-3);
    }

    /** With the memory of a world that was copied, the copy goes on in the same way. */
    @Test
    void itsMemoryIsAValueThatGoesWithACopyOfTheWorld() {
        ProcessorMemory memory = new ProcessorMemory();
        memory.remember(1, "K", new FilterMemory(1, MatrixUtils.createRealIdentityMatrix(12), 0));
        ProcessorMemory copy = memory.copy();
        memory.remember(1, "K", new FilterMemory(2, MatrixUtils.createRealIdentityMatrix(12), 0));
        memory.remember(2, "K", new FilterMemory(2, MatrixUtils.createRealIdentityMatrix(12), 0));
        assertThat(copy.recall(1, "K", FilterMemory.class).orElseThrow().time()).isEqualTo(1);
        memory.restore(copy);
        assertThat(memory.recall(1, "K", FilterMemory.class).orElseThrow().time()).isEqualTo(1);
        assertThat(memory.recall(2, "K", FilterMemory.class)).isEmpty();
        assertThat(memory.recall(1, "K", String.class)).isEmpty();
    }

    @Test
    void noiseIsNotNegative() {
        assertThatThrownBy(
                        () ->
                                new KalmanFilterFeedbackHandler(
                                        -1, 0, new Deviations(1, 1, 1, 1), INITIAL))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("the acceleration of a Kalman filter must be 0");
        assertThatThrownBy(() -> new Deviations(1, 0, 1, 1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("the angle of standard deviations must be above 0 rad");
    }
}
