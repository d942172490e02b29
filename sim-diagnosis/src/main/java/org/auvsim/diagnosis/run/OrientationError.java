package org.auvsim.diagnosis.run;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.server.feedback.RigidMotion;

import java.util.stream.IntStream;

/**
 * By how much an orientation is turned from a measured one. Of an angle that was measured without
 * the others it is the difference of that angle alone: a heading is the same heading whatever the
 * body's roll and pitch.
 */
public final class OrientationError {
    private OrientationError() {}

    /**
     * That of an orientation at a sample (rad): the rotation vector, in the axes that the run's
     * frame tells, if the measured one is whole; else differences of roll, pitch and yaw.
     *
     * @throws java.util.NoSuchElementException if none was measured there
     */
    public static Vec3 of(Quat told, MeasuredRun run, int sample) {
        Quat measured = run.orientation(sample).orElseThrow();
        if (isWhole(run, sample)) {
            Vec3 turn = turn(measured, told);
            boolean isInBody = run.frame(Channel.ORIENTATION) == Frame.BODY;
            return isInBody ? measured.rotateInverse(turn) : turn;
        }
        Vec3 off = EulerAngles.of(told).minus(EulerAngles.of(measured));
        return new Vec3(wrapped(off.x()), wrapped(off.y()), wrapped(off.z()));
    }

    /** The rotation vector (rad, world axes) that turns one orientation into another. */
    public static Vec3 turn(Quat from, Quat to) {
        double[] error = still(to).minus(still(from));
        return new Vec3(error[3], error[4], error[5]);
    }

    private static RigidMotion still(Quat orientation) {
        return new RigidMotion(Vec3.ZERO, orientation, Vec3.ZERO, Vec3.ZERO);
    }

    private static boolean isWhole(MeasuredRun run, int sample) {
        return IntStream.range(0, 3)
                .noneMatch(axis -> Double.isNaN(run.value(Channel.ORIENTATION, sample, axis)));
    }

    /** The same angle (rad), from -pi to pi. */
    private static double wrapped(double angle) {
        return Math.IEEEremainder(angle, 2 * Math.PI);
    }
}
