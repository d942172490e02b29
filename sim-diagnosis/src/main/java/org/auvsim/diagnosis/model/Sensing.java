package org.auvsim.diagnosis.model;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

/**
 * What measuring does to a motion: what sensors tell when the body moves so. Each change is made in
 * the order of the components.
 *
 * @param delay by which what is told is old (s)
 * @param positionDelay by which positions are older still (s)
 * @param arm from the body's origin to the point whose position is told (m, body)
 * @param scale of coordinates, less 1
 * @param turn by which the sensors' axes are off the world's (rotation vector, rad)
 * @param yaw by which orientations are off about the vertical (rad)
 * @param yawRate by which that grows (rad/s)
 * @param compass by which headings are off, on each by another angle
 * @param offset by which positions are off (m)
 * @param drift by which positions run away from the run's beginning on (m/s); a part goes on with
 *     what it was there
 */
public record Sensing(
        double delay,
        double positionDelay,
        Vec3 arm,
        Vec3 scale,
        Vec3 turn,
        double yaw,
        double yawRate,
        CompassDeviation compass,
        Vec3 offset,
        Vec3 drift) {
    /** What is told is what is. */
    public static final Sensing EXACT =
            new Sensing(
                    0,
                    0,
                    Vec3.ZERO,
                    Vec3.ZERO,
                    Vec3.ZERO,
                    0,
                    0,
                    CompassDeviation.NONE,
                    Vec3.ZERO,
                    Vec3.ZERO);

    /** The same, older by a time (s). */
    public Sensing delayed(double more) {
        return new Sensing(
                delay + more,
                positionDelay,
                arm,
                scale,
                turn,
                yaw,
                yawRate,
                compass,
                offset,
                drift);
    }

    /** The same, its positions older by a time (s). */
    public Sensing withLatePositions(double more) {
        return new Sensing(
                delay,
                positionDelay + more,
                arm,
                scale,
                turn,
                yaw,
                yawRate,
                compass,
                offset,
                drift);
    }

    /** The same, of a point that is further from the body's origin (m, body). */
    public Sensing armed(Vec3 more) {
        return new Sensing(
                delay,
                positionDelay,
                arm.plus(more),
                scale,
                turn,
                yaw,
                yawRate,
                compass,
                offset,
                drift);
    }

    /** The same, its coordinates larger by shares. */
    public Sensing scaled(Vec3 more) {
        return new Sensing(
                delay,
                positionDelay,
                arm,
                scale.plus(more),
                turn,
                yaw,
                yawRate,
                compass,
                offset,
                drift);
    }

    /** The same, its axes turned on (rotation vector, rad). */
    public Sensing turned(Vec3 more) {
        return new Sensing(
                delay,
                positionDelay,
                arm,
                scale,
                turn.plus(more),
                yaw,
                yawRate,
                compass,
                offset,
                drift);
    }

    /** The same, its orientations off by more (rad, rad/s) about the vertical. */
    public Sensing yawed(double more, double moreRate) {
        return new Sensing(
                delay,
                positionDelay,
                arm,
                scale,
                turn,
                yaw + more,
                yawRate + moreRate,
                compass,
                offset,
                drift);
    }

    /**
     * The same beside iron that turns with the body: more of the heading's sine and cosine (rad).
     */
    public Sensing besideIron(double sine, double cosine) {
        return new Sensing(
                delay,
                positionDelay,
                arm,
                scale,
                turn,
                yaw,
                yawRate,
                compass.plus(sine, cosine),
                offset,
                drift);
    }

    /** The same, its positions off by more (m). */
    public Sensing shifted(Vec3 more) {
        return new Sensing(
                delay,
                positionDelay,
                arm,
                scale,
                turn,
                yaw,
                yawRate,
                compass,
                offset.plus(more),
                drift);
    }

    /** The same, its positions running away faster (m/s). */
    public Sensing drifting(Vec3 more) {
        return new Sensing(
                delay,
                positionDelay,
                arm,
                scale,
                turn,
                yaw,
                yawRate,
                compass,
                offset,
                drift.plus(more));
    }

    /**
     * What is told of a motion at a run's samples.
     *
     * @param motions at samples from {@code from} on
     * @param samples how many of them are asked for
     */
    public RigidMotion[] of(RigidMotion[] motions, MeasuredRun run, int from, int samples) {
        if (equals(EXACT) || isLost(motions[0])) {
            return motions;
        }
        RigidMotion[] told = new RigidMotion[samples];
        for (int k = 0; k < samples; k++) {
            double time = run.time(from + k);
            RigidMotion then =
                    delay == 0 ? motions[k] : Course.at(motions, run, from, time - delay);
            RigidMotion before =
                    positionDelay == 0
                            ? then
                            : Course.at(motions, run, from, time - delay - positionDelay);
            told[k] = of(then, before, time - run.whole().time(0), run);
        }
        return told;
    }

    /** Whether everything is told at once. */
    public boolean isPrompt() {
        return delay == 0 && positionDelay == 0;
    }

    /** How old what is told of a channel is (s); below 0: how far ahead. */
    public double age(Channel channel) {
        return channel == Channel.POSITION ? delay + positionDelay : delay;
    }

    private static boolean isLost(RigidMotion motion) {
        return Double.isNaN(motion.position().x());
    }

    /** Velocities that sensors of the body tell in its axes are what they are, however told. */
    private RigidMotion of(RigidMotion then, RigidMotion before, double since, MeasuredRun run) {
        Quat axes = rotation(turn);
        double off = yaw + yawRate * since + compass.of(then.orientation());
        Quat heading = rotation(new Vec3(0, 0, off)).times(axes);
        Vec3 p = before.position().plus(before.orientation().rotate(arm));
        Vec3 v = then.velocity();
        return new RigidMotion(
                axes.rotate(inScale(p)).plus(offset).plus(drift.times(since)),
                heading.times(then.orientation()).normalized(),
                run.frame(Channel.VELOCITY) == Frame.BODY
                        ? heading.rotate(v)
                        : axes.rotate(inScale(v)).plus(drift),
                run.frame(Channel.ANGULAR_VELOCITY) == Frame.BODY
                        ? heading.rotate(then.angularVelocity())
                        : axes.rotate(then.angularVelocity()));
    }

    private Vec3 inScale(Vec3 v) {
        return new Vec3(v.x() * (1 + scale.x()), v.y() * (1 + scale.y()), v.z() * (1 + scale.z()));
    }

    private static Quat rotation(Vec3 turn) {
        double[] change = {0, 0, 0, turn.x(), turn.y(), turn.z(), 0, 0, 0, 0, 0, 0};
        return new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO)
                .plus(change)
                .orientation();
    }
}
