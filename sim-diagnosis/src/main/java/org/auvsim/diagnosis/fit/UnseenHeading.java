package org.auvsim.diagnosis.fit;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.LocalMotion;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Shooting;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.server.feedback.RigidMotion;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Finds how a body is turned when a run begins, where neither angles nor the start are known: the
 * path tells it. From a heading that is far off a fit does not find the right one, and a body that
 * may tumble fits many a path. So it is taken to be about as upright and as slow in turning as the
 * scenario has it, and tried at headings all around; one that may tumble counts where it fits and
 * none of those does.
 */
final class UnseenHeading {
    private static final int AROUND = 8;
    private static final int YAW = 5;
    private static final int STEPS = 12;

    /** So many headings are tried to the end. */
    private static final int NEAREST = 2;

    /** So many samples tell where it is and how fast. */
    private static final int BEGINNING = 8;

    /** How far a start may be from the scenario's in roll and pitch (rad) and in rates (rad/s). */
    private static final double TILT = 0.1;

    private static final double RATE = 0.1;

    /** The same about the vertical, where vehicles turn most (rad/s). */
    private static final double YAW_RATE = 0.3;

    /** A motion fits if chi squared a number is below this. */
    private static final double FITS = 1.5;

    private final Stepping stepping;
    private final Hypothesis hypothesis;
    private final Misses data;
    private final Noise noise;
    private final Course course;

    /** Of a run under a hypothesis. */
    UnseenHeading(
            Stepping stepping, Hypothesis hypothesis, Misses data, Noise noise, Course course) {
        this.stepping = stepping;
        this.hypothesis = hypothesis;
        this.data = data;
        this.noise = noise;
        this.course = course;
    }

    /** Whether there is something to find. */
    boolean isUnseen() {
        MeasuredRun run = data.run();
        return run.start().filter(start -> start.isKnown(YAW)).isEmpty()
                && !run.measures(Channel.ORIENTATION)
                && data.shown(0)[YAW]
                && turnsFreely(stepping.model());
    }

    private static boolean turnsFreely(BelievedModel model) {
        double[] yaw = new double[RigidMotion.SIZE];
        yaw[YAW] = 1;
        return model.free(yaw)[YAW] == 1;
    }

    /** Windows that follow from the heading that was found. */
    List<Window> windows() {
        RigidMotion stated = begun(stepping.model().start());
        Judged first = whole(upright(stated));
        if (fits(first)) {
            return again(first);
        }
        Judged best =
                nearest(stated, first).parallelStream()
                        .map(this::whole)
                        .min(Comparator.comparingDouble(Judged::cost))
                        .filter(other -> other.cost() < first.cost())
                        .orElse(first);
        return fits(best) ? again(best) : tumbling().orElseGet(() -> again(best));
    }

    /** The run from those headings all around that come nearest to it within a few steps. */
    private List<Misses> nearest(RigidMotion stated, Judged first) {
        List<Window> windows = following(first.fit().data().getFirst());
        return IntStream.range(1, AROUND)
                .parallel()
                .mapToObj(i -> 2 * Math.PI * i / AROUND)
                .map(
                        by ->
                                near(
                                        upright(turned(stated, by)),
                                        windows.stream()
                                                .map(w -> w.startingAt(turned(w.start(), by)))
                                                .toList()))
                .sorted(Comparator.comparingDouble(Judged::cost))
                .limit(NEAREST)
                .map(near -> near.fit().data().getFirst())
                .toList();
    }

    private static boolean fits(Judged judged) {
        return judged.cost() < FITS * judged.outcome().count();
    }

    /** The run, of whose start is known that it is nearly so, and what else is known of it. */
    private Misses upright(RigidMotion start) {
        double[] most = new double[RigidMotion.SIZE];
        Arrays.fill(most, Double.POSITIVE_INFINITY);
        for (int axis = 0; axis < 2; axis++) {
            most[3 + axis] = TILT;
            most[9 + axis] = RATE;
        }
        most[9 + 2] = YAW_RATE;
        List<Double> deviations =
                IntStream.range(0, most.length).mapToObj(i -> Math.min(most[i], known(i))).toList();
        RigidMotion from =
                data.run().start().map(known -> known.orElse(start).motion()).orElse(start);
        MeasuredRun held = data.run().startingAt(new KnownStart(from, deviations));
        return Misses.of(List.of(held), noise).getFirst();
    }

    private double known(int number) {
        return data.run()
                .start()
                .map(start -> start.deviations().get(number))
                .orElse(Double.POSITIVE_INFINITY);
    }

    /** Where the run begins, and as fast, turned and turning as the scenario has it. */
    private RigidMotion begun(RigidMotion stated) {
        int few = Math.min(BEGINNING, data.run().size() - 1);
        RigidMotion measured = LocalMotion.at(data.run(), stated, 0, few);
        return new RigidMotion(
                measured.position(),
                stated.orientation(),
                measured.velocity(),
                stated.angularVelocity());
    }

    private static RigidMotion turned(RigidMotion motion, double by) {
        Quat turn = Quat.ofAxisAngle(new Vec3(0, 0, 1), by);
        return new RigidMotion(
                motion.position(),
                turn.times(motion.orientation()),
                motion.velocity(),
                motion.angularVelocity());
    }

    /** The windows of a run from where the whole of it fits best. */
    private List<Window> again(Judged whole) {
        return following(upright(whole.fit().windows().getFirst().getFirst().start()));
    }

    private Optional<List<Window>> tumbling() {
        List<Window> windows = following(data);
        return Optional.of(windows).filter(w -> fits(whole(data, w)));
    }

    private List<Window> following(Misses of) {
        Shooting shooting = new Shooting(stepping, hypothesis.in(stepping.variant()), of);
        return new Following(shooting, noise, course).windows();
    }

    private Judged whole(Misses of) {
        return whole(of, following(of));
    }

    private Judged whole(Misses of, List<Window> windows) {
        return Descent.of(near(of, windows)).steps(STEPS, Double.POSITIVE_INFINITY, course);
    }

    private Judged near(Misses of, List<Window> windows) {
        Fit fit = new Fit(stepping, List.of(of), hypothesis, List.of(windows), Knowledge.NONE);
        return Refinement.approach(fit, 1, Double.POSITIVE_INFINITY, course).judged();
    }
}
