package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** Whether the numbers of a run can be what they are taken for. */
final class Plausibility {
    /** A unit that is off by 1000 makes ratios within these. */
    private static final double LEAST = 300;

    private static final double MOST = 3000;

    /** Nobody turns so far about an axis (rad) without unwrapping. */
    private static final double SEVERAL_TURNS = 20;

    /** So much of a run (samples) tells how far the model goes. */
    private static final int ENOUGH = 500;

    private final BelievedModel model;
    private final MeasuredRun run;

    Plausibility(BelievedModel model, MeasuredRun run) {
        this.model = model;
        this.run = run;
    }

    /**
     * What looks wrong but may be right.
     *
     * @throws DocumentException if nothing moves at all
     */
    List<String> notices(Path file) throws DocumentException {
        if (isConstant()) {
            throw new DocumentException(
                    "%s: every measured number of run '%s' is the same from its first row to its last; nothing can be learnt from it"
                            .formatted(file, run.name()));
        }
        List<String> notices = new ArrayList<>();
        velocity().map(text -> run.name() + ": " + text).ifPresent(notices::add);
        way().map(text -> run.name() + ": " + text).ifPresent(notices::add);
        turn().map(text -> run.name() + ": " + text).ifPresent(notices::add);
        return notices;
    }

    private boolean isConstant() {
        for (Channel channel : Channel.values()) {
            for (int axis = 0; axis < 3; axis++) {
                if (channel != Channel.ORIENTATION && range(channel, axis) > 0) {
                    return false;
                }
            }
        }
        return largestTurn() == 0;
    }

    /** Largest less smallest number; 0 if there is none. */
    private double range(Channel channel, int axis) {
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < run.size(); k++) {
            double value = run.value(channel, k, axis);
            if (!Double.isNaN(value)) {
                least = Math.min(least, value);
                most = Math.max(most, value);
            }
        }
        return Math.max(0, most - least);
    }

    private double largestTurn() {
        Optional<Quat> first = Optional.empty();
        double largest = 0;
        for (int k = 0; k < run.size(); k++) {
            Optional<Quat> now = run.orientation(k);
            first = first.or(() -> now);
            if (now.isPresent()) {
                Quat turn = first.get().conjugate().times(now.get());
                largest = Math.max(largest, new Vec3(turn.x(), turn.y(), turn.z()).norm());
            }
        }
        return largest;
    }

    /** Velocities beside the way that positions go; both in the world's axes or both as sizes. */
    private Optional<String> velocity() {
        double way = 0;
        double told = 0;
        for (int k = 1; k < run.size(); k++) {
            Optional<Vec3> from = run.vector(Channel.POSITION, k - 1);
            Optional<Vec3> to = run.vector(Channel.POSITION, k);
            Optional<Vec3> velocity = run.vector(Channel.VELOCITY, k);
            if (from.isPresent() && to.isPresent() && velocity.isPresent()) {
                way += to.get().distance(from.get());
                told += velocity.get().norm() * (run.time(k) - run.time(k - 1));
            }
        }
        return off(way, told)
                .map(
                        ratio ->
                                "positions go %s times as far as velocities say: is one of them in another unit?"
                                        .formatted(Figures.shown(ratio, 2)));
    }

    /** How far it goes beside what the model would do from rest in the same time. */
    private Optional<String> way() {
        int last = Math.min(run.size() - 1, ENOUGH);
        Optional<Vec3> start = run.vector(Channel.POSITION, 0);
        OptionalDouble measured = farthest(last);
        if (start.isEmpty() || measured.isEmpty()) {
            return Optional.empty();
        }
        RigidMotion still =
                new RigidMotion(
                        start.get(),
                        run.orientation(0).orElse(model.variant().body().orientation()),
                        Vec3.ZERO,
                        Vec3.ZERO);
        RigidMotion[] motion =
                Ensemble.simulate(
                        model, run, 0, last, List.of(new Ensemble.Entrant(model.variant(), still)))[
                        0];
        double simulated = 0;
        for (RigidMotion at : motion) {
            simulated = Math.max(simulated, at.position().distance(start.get()));
        }
        double from = simulated;
        return off(measured.getAsDouble(), simulated)
                .filter(ratio -> ratio > 1)
                .map(
                        ratio ->
                                "goes %s m within %s s, %s times as far as the model from rest (%s m): are positions in mm, or times in another unit?"
                                        .formatted(
                                                Figures.shown(measured.getAsDouble()),
                                                Figures.shown(run.time(last) - run.time(0)),
                                                Figures.shown(ratio, 2),
                                                Figures.shown(from)));
    }

    private OptionalDouble farthest(int last) {
        Vec3 start = run.vector(Channel.POSITION, 0).orElse(Vec3.ZERO);
        OptionalDouble farthest = OptionalDouble.empty();
        for (int k = 0; k <= last; k++) {
            Optional<Vec3> at = run.vector(Channel.POSITION, k);
            if (at.isPresent()) {
                farthest =
                        OptionalDouble.of(Math.max(farthest.orElse(0), at.get().distance(start)));
            }
        }
        return farthest;
    }

    private static Optional<Double> off(double one, double other) {
        double ratio = one / other;
        boolean isOff =
                (ratio >= LEAST && ratio <= MOST) || (ratio >= 1 / MOST && ratio <= 1 / LEAST);
        return isOff && one > 0 && other > 0 ? Optional.of(ratio) : Optional.empty();
    }

    /** Rates that are too fast for radians. */
    private Optional<String> turn() {
        double fastest = 0;
        for (int axis = 0; axis < 3; axis++) {
            fastest = Math.max(fastest, range(Channel.ANGULAR_VELOCITY, axis));
        }
        String axes = run.frame(Channel.ANGULAR_VELOCITY) == Frame.BODY ? "p, q, r" : "wx, wy, wz";
        return fastest > SEVERAL_TURNS
                ? Optional.of(
                        "%s differ by up to %s rad/s: are they in degrees (--degrees)?"
                                .formatted(axes, Figures.shown(fastest)))
                : Optional.empty();
    }
}
