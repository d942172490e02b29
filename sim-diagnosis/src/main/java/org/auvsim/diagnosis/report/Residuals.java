package org.auvsim.diagnosis.report;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.OrientationError;
import org.auvsim.server.feedback.RigidMotion;

import java.util.List;

/**
 * What was measured of a run, less what a model tells; NaN where nothing was measured.
 *
 * @param told sample by sample; no longer than the run
 */
record Residuals(MeasuredRun run, List<RigidMotion> told) {
    /** How many samples there are. */
    int size() {
        return Math.min(run.size(), told.size());
    }

    /** In the channel's unit; of orientations as {@link OrientationError} has it. */
    Vec3 of(Channel channel, int sample) {
        RigidMotion motion = told.get(sample);
        return switch (channel) {
            case POSITION -> measured(channel, sample).minus(motion.position());
            case ORIENTATION -> measured(channel, sample).plus(turn(sample, motion));
            case VELOCITY -> inFrame(channel, sample, motion.velocity(), motion.orientation());
            case ANGULAR_VELOCITY ->
                    inFrame(channel, sample, motion.angularVelocity(), motion.orientation());
        };
    }

    /** Of an orientation: 0 where it was measured. */
    private Vec3 measured(Channel channel, int sample) {
        return new Vec3(
                run.value(channel, sample, 0),
                run.value(channel, sample, 1),
                run.value(channel, sample, 2));
    }

    private Vec3 turn(int sample, RigidMotion motion) {
        return run.orientation(sample).isPresent()
                ? OrientationError.of(motion.orientation(), run, sample).times(-1)
                : Vec3.ZERO;
    }

    private Vec3 inFrame(Channel channel, int sample, Vec3 world, Quat orientation) {
        return measured(channel, sample)
                .minus(run.frame(channel) == Frame.BODY ? orientation.rotateInverse(world) : world);
    }

    /**
     * Root mean square of all numbers that were measured of a channel, to be compared with the
     * noise of one; NaN if none was.
     */
    double rootMeanSquare(Channel channel) {
        double sum = 0;
        int numbers = 0;
        for (int k = 0; k < size(); k++) {
            Vec3 miss = of(channel, k);
            for (int axis = 0; axis < 3; axis++) {
                double number = miss.component(axis);
                if (!Double.isNaN(number)) {
                    sum += number * number;
                    numbers++;
                }
            }
        }
        return numbers == 0 ? Double.NaN : Math.sqrt(sum / numbers);
    }
}
