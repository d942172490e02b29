package org.auvsim.diagnosis.run;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.server.feedback.RigidMotion;

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
        if (!run.isWhollyOriented(sample)) {
            return ofAngles(told, run, sample);
        }
        Quat measured = run.orientation(sample).orElseThrow();
        Vec3 turn = turn(measured, told);
        boolean isInBody = run.frame(Channel.ORIENTATION) == Frame.BODY;
        return isInBody ? measured.rotateInverse(turn) : turn;
    }

    /**
     * Differences of roll, pitch and yaw (rad) at a sample, as if not all had been measured.
     *
     * @throws java.util.NoSuchElementException if none was measured there
     */
    public static Vec3 ofAngles(Quat told, MeasuredRun run, int sample) {
        Vec3 angles = run.angles(sample).orElseThrow();
        return wrapped(nearer(EulerAngles.of(told), angles).minus(angles));
    }

    /** The angles (rad) of a measured orientation: of its two sets those nearer to none. */
    static Vec3 angles(Quat measured) {
        return nearer(EulerAngles.of(measured), Vec3.ZERO);
    }

    /**
     * Those of an orientation's two sets of angles that are nearer to some: of a pendulum, whose
     * pitch goes all around, one with a pitch of more than a quarter of a turn.
     */
    private static Vec3 nearer(Vec3 angles, Vec3 to) {
        Vec3 others = new Vec3(angles.x() + Math.PI, Math.PI - angles.y(), angles.z() + Math.PI);
        return off(others, to) < off(angles, to) ? others : angles;
    }

    private static double off(Vec3 angles, Vec3 from) {
        Vec3 off = wrapped(angles.minus(from));
        return Math.abs(off.x()) + Math.abs(off.y()) + Math.abs(off.z());
    }

    /** The same angles (rad), from -pi to pi. */
    private static Vec3 wrapped(Vec3 angles) {
        return new Vec3(wrapped(angles.x()), wrapped(angles.y()), wrapped(angles.z()));
    }

    /** The rotation vector (rad, world axes) that turns one orientation into another. */
    public static Vec3 turn(Quat from, Quat to) {
        double[] error = still(to).minus(still(from));
        return new Vec3(error[3], error[4], error[5]);
    }

    private static RigidMotion still(Quat orientation) {
        return new RigidMotion(Vec3.ZERO, orientation, Vec3.ZERO, Vec3.ZERO);
    }

    private static double wrapped(double angle) {
        return Math.abs(angle) <= Math.PI ? angle : Math.IEEEremainder(angle, 2 * Math.PI);
    }
}
