package org.auvsim.diagnosis.model;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

/**
 * What measuring does to a motion: what sensors tell when the body moves so. What is told is late
 * first, then of another place, and along other axes at last.
 *
 * @param lateness how old it is
 * @param positioning which place of the body it is of, and how far off
 * @param alignment how its axes and headings are off
 */
public record Sensing(Lateness lateness, Positioning positioning, Alignment alignment) {
    /** What is told is what is. */
    public static final Sensing EXACT =
            new Sensing(Lateness.NONE, Positioning.EXACT, Alignment.EXACT);

    /** The same, older by a time (s). */
    public Sensing delayed(double more) {
        return later(new Lateness(more, 0, 0));
    }

    /** The same, its positions older by a time (s). */
    public Sensing withLatePositions(double more) {
        return later(new Lateness(0, more, 0));
    }

    /** The same, its orientations older by a time (s). */
    public Sensing withLateOrientations(double more) {
        return later(new Lateness(0, 0, more));
    }

    private Sensing later(Lateness more) {
        return new Sensing(lateness.plus(more), positioning, alignment);
    }

    /** The same, of a point that is further from the body's origin (m, body). */
    public Sensing armed(Vec3 more) {
        return placed(new Positioning(more, Vec3.ZERO, Vec3.ZERO, Vec3.ZERO));
    }

    /** The same, its coordinates larger by shares. */
    public Sensing scaled(Vec3 more) {
        return placed(new Positioning(Vec3.ZERO, more, Vec3.ZERO, Vec3.ZERO));
    }

    /** The same, its positions off by more (m). */
    public Sensing shifted(Vec3 more) {
        return placed(new Positioning(Vec3.ZERO, Vec3.ZERO, more, Vec3.ZERO));
    }

    /** The same, its positions running away faster (m/s). */
    public Sensing drifting(Vec3 more) {
        return placed(new Positioning(Vec3.ZERO, Vec3.ZERO, Vec3.ZERO, more));
    }

    private Sensing placed(Positioning more) {
        return new Sensing(lateness, positioning.plus(more), alignment);
    }

    /** The same, its axes turned on (rotation vector, rad). */
    public Sensing turned(Vec3 more) {
        return aligned(new Alignment(more, 0, 0, CompassDeviation.NONE));
    }

    /** The same, its orientations off by more (rad, rad/s) about the vertical. */
    public Sensing yawed(double more, double moreRate) {
        return aligned(new Alignment(Vec3.ZERO, more, moreRate, CompassDeviation.NONE));
    }

    /**
     * The same beside iron that turns with the body: more of the heading's sine and cosine (rad).
     */
    public Sensing besideIron(double sine, double cosine) {
        return aligned(new Alignment(Vec3.ZERO, 0, 0, new CompassDeviation(sine, cosine)));
    }

    private Sensing aligned(Alignment more) {
        return new Sensing(lateness, positioning, alignment.plus(more));
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
                    lateness.ofAll() == 0
                            ? motions[k]
                            : Course.at(motions, run, from, time - lateness.ofAll());
            told[k] =
                    of(
                            then,
                            lateness.ofPositions() == 0
                                    ? then
                                    : Course.at(motions, run, from, time - age(Channel.POSITION)),
                            lateness.ofOrientations() == 0
                                    ? then.orientation()
                                    : Course.at(motions, run, from, time - age(Channel.ORIENTATION))
                                            .orientation(),
                            time - run.whole().time(0),
                            run);
        }
        return told;
    }

    /** Whether everything is told at once. */
    public boolean isPrompt() {
        return lateness.equals(Lateness.NONE);
    }

    /** How old what is told of a channel is (s); below 0: how far ahead. */
    public double age(Channel channel) {
        return lateness.of(channel);
    }

    private static boolean isLost(RigidMotion motion) {
        return Double.isNaN(motion.position().x());
    }

    /**
     * Velocities that sensors of the body tell in its axes are what they are, however told.
     *
     * @param then how the body moves
     * @param placed when its position is told
     * @param turned its orientation that is told
     */
    private RigidMotion of(
            RigidMotion then, RigidMotion placed, Quat turned, double since, MeasuredRun run) {
        Quat axes = alignment.axes();
        Quat heading = alignment.misheading(turned, since).times(axes);
        Vec3 v = then.velocity();
        Vec3 w = then.angularVelocity();
        return new RigidMotion(
                positioning.place(placed, axes, since),
                heading.times(turned).normalized(),
                run.frame(Channel.VELOCITY) == Frame.BODY
                        ? heading.rotate(v)
                        : positioning.velocity(v, axes),
                run.frame(Channel.ANGULAR_VELOCITY) == Frame.BODY
                        ? heading.rotate(w)
                        : axes.rotate(w));
    }
}
