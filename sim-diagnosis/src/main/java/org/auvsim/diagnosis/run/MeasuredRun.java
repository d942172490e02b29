package org.auvsim.diagnosis.run;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.server.feedback.RigidMotion;

import java.util.List;
import java.util.Optional;

/**
 * A measured run: where a body was when, and what it was told to do. Times increase. Immutable.
 *
 * @param name for people, as that of its file
 * @param samples at least two
 * @param commandNames the propulsors that were commanded
 * @param start the motion at the first sample, if it is known otherwise than by the measurement
 */
public record MeasuredRun(
        String name,
        List<Sample> samples,
        List<String> commandNames,
        Optional<KnownStart> start) {
    /**
     * What was measured at an instant.
     *
     * @param time (s)
     * @param position of the origin (m, world)
     * @param orientation body to world
     * @param commands of the propulsors named, each holds until the next sample
     */
    public record Sample(
            double time, Optional<Vec3> position, Optional<Quat> orientation, List<Double> commands) {
        /** The list cannot be changed. */
        public Sample {
            commands = List.copyOf(commands);
        }
    }

    /**
     * A motion that is known.
     *
     * @param deviations standard deviations of position (m), rotation vector (rad), velocity (m/s)
     *     and angular velocity (rad/s): twelve numbers
     */
    public record KnownStart(RigidMotion motion, List<Double> deviations) {}

    /** The lists cannot be changed. */
    public MeasuredRun {
        samples = List.copyOf(samples);
        commandNames = List.copyOf(commandNames);
    }

    /** Number of samples. */
    public int size() {
        return samples.size();
    }

    /** When a sample was taken (s). */
    public double time(int sample) {
        return samples.get(sample).time();
    }

    /** Whether orientations were measured. */
    public boolean hasOrientation() {
        return samples.stream().anyMatch(sample -> sample.orientation().isPresent());
    }
}
