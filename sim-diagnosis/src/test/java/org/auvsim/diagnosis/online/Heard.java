package org.auvsim.diagnosis.online;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.auvsml.message.feedback.Measurement;
import org.auvsim.auvsml.message.feedback.MeasurementFrame;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.server.feedback.AppliedFeedback;
import org.auvsim.server.feedback.MeasurementErrors;
import org.auvsim.server.feedback.Target;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;

/** What a learner hears of the object 1: where it is measured to be, and what it is told. */
final class Heard {
    private static final MeasurementErrors NONE =
            new MeasurementErrors(
                    OptionalDouble.empty(),
                    OptionalDouble.empty(),
                    OptionalDouble.empty(),
                    OptionalDouble.empty());

    /**
     * A position (m).
     *
     * @param read is run when its covariance, of 1 m along each axis, is read
     */
    record Positioned(double timestamp, Vec3 position, Runnable read) implements FeedbackMessage {
        @Override
        public long worldObjectId() {
            return 1;
        }

        @Override
        public String handlerName() {
            return "LearningFeedbackHandler";
        }

        @Override
        public Measurement measurement() {
            return new Measurement(
                    MeasurementFrame.WORLD,
                    Optional.of(position),
                    Optional.empty(),
                    Optional.empty(),
                    Optional.empty(),
                    Optional.empty());
        }
    }

    private Heard() {}

    /** A world of that object, in steps of 1 s, with the actuator {@code screw}. */
    static World world() {
        return World.builder()
                .timeStep(1)
                .add(
                        WorldObjectDefinition.named("body")
                                .volume(new Sphere(0.2))
                                .mass(10)
                                .component(
                                        new Propulsor("screw", 1, 0, Vec3.ZERO, new Vec3(1, 0, 0)))
                                .build())
                .build();
    }

    /** Feedback of a time (s). */
    static Positioned feedback(double time) {
        return new Positioned(time, new Vec3(0.1 * time, Math.sin(time), 0), () -> {});
    }

    /** That it was used. */
    static AppliedFeedback applied(Positioned feedback) {
        return new AppliedFeedback(
                1,
                feedback.timestamp(),
                feedback.handlerName(),
                NONE,
                NONE,
                target(feedback),
                true,
                List.of());
    }

    private static Target target(Positioned feedback) {
        return new Target(
                Optional.of(feedback.position()),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.of(covariance(feedback.read())));
    }

    private static RealMatrix covariance(Runnable read) {
        return new Array2DRowRealMatrix(MatrixUtils.createRealIdentityMatrix(3).getData()) {
            @Override
            public double getEntry(int row, int column) {
                read.run();
                return super.getEntry(row, column);
            }
        };
    }

    static Observation measured(double time) {
        return new Observation.Measured(time, target(feedback(time)));
    }

    /** All of a motion at rest, with standard deviations along the world's axes. */
    static Observation measured(double time, double... deviations) {
        double[] variances = Arrays.stream(deviations).map(d -> d * d).toArray();
        return new Observation.Measured(
                time,
                new Target(
                        Optional.of(Vec3.ZERO),
                        Optional.of(Quat.IDENTITY),
                        Optional.of(Vec3.ZERO),
                        Optional.of(Vec3.ZERO),
                        Optional.of(MatrixUtils.createRealDiagonalMatrix(variances))));
    }

    /** A position alone, each coordinate with this standard deviation. */
    static Observation placed(double time, Vec3 position, double deviation) {
        return new Observation.Measured(
                time,
                new Target(
                        Optional.of(position),
                        Optional.empty(),
                        Optional.empty(),
                        Optional.empty(),
                        Optional.of(alike(deviation))));
    }

    /** An angular velocity alone. */
    static Observation turning(double time, Vec3 rate, double deviation) {
        return new Observation.Measured(
                time,
                new Target(
                        Optional.empty(),
                        Optional.empty(),
                        Optional.empty(),
                        Optional.of(rate),
                        Optional.of(alike(deviation))));
    }

    private static RealMatrix alike(double deviation) {
        return MatrixUtils.createRealIdentityMatrix(3).scalarMultiply(deviation * deviation);
    }

    /** A level of the actuator {@code screw}. */
    static Observation told(double time, double level) {
        return new Observation.Told(time, new TreeMap<>(Map.of("screw", level)), List.of());
    }

    /** A force along x (N). */
    static Observation pushed(double time, NamedForce force) {
        return new Observation.Told(
                time,
                new TreeMap<>(Map.of(force.name() + ".x", force.vector().x())),
                List.of(force));
    }
}
