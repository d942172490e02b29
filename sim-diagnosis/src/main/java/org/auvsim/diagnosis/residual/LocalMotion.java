package org.auvsim.diagnosis.residual;

import org.apache.commons.math3.fitting.PolynomialCurveFitter;
import org.apache.commons.math3.fitting.WeightedObservedPoints;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.OrientationError;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;

/**
 * The motion at a sample by what was measured around it, without any model: local parabolas. What
 * was not measured is as in a motion given, velocities along the body's own axes.
 */
public final class LocalMotion {
    private static final int DEGREE = 2;

    /** So many samples tell how a run begins. */
    private static final int BEGINNING = 8;

    /** Turns so few, as those of what spins fast, are noisy: a parabola would follow that. */
    private static final int FEW = 5;

    /** A rotation vector (rad) beyond half a turn would be that of the other way round. */
    private static final double MOST_TURN = 2;

    /** A path of a body that has turned by more (rad) may wind. */
    private static final double WINDING = 1;

    /** How far a body under way may be tilted (rad), and how fast that may change (rad/s). */
    private static final double TILT = 0.3;

    private static final double TILTING = 0.2;

    private final MeasuredRun run;
    private final RigidMotion otherwise;
    private final int from;
    private final int to;

    private LocalMotion(MeasuredRun run, RigidMotion otherwise, int from, int to) {
        this.run = run;
        this.otherwise = otherwise;
        this.from = from;
        this.to = to;
    }

    /** The motion at a sample by the samples from it up to {@code to}. */
    public static RigidMotion at(MeasuredRun run, RigidMotion otherwise, int from, int to) {
        return new LocalMotion(run, otherwise, from, to).motion();
    }

    /**
     * How a run begins by a model: as is stated, or else where and turned as was measured, and as
     * fast as the model, unless velocities were measured.
     */
    public static RigidMotion begin(MeasuredRun run, BelievedModel model) {
        return model.nearestStart(
                run.start().map(KnownStart::motion).orElseGet(() -> placed(run, model.start())));
    }

    private static RigidMotion placed(MeasuredRun run, RigidMotion otherwise) {
        RigidMotion local = beginning(run, otherwise);
        Quat turned = local.orientation();
        LocalMotion begun = new LocalMotion(run, otherwise, 0, run.size() - 1);
        return new RigidMotion(
                local.position(),
                turned,
                begun.asMeasured(Channel.VELOCITY, turned, begun.carried(turned)),
                begun.asMeasured(Channel.ANGULAR_VELOCITY, turned, otherwise.angularVelocity()));
    }

    /**
     * A run of whose start all is known: what nothing was known of is as it was measured, or else
     * as in the model; of a body that was under way, about so.
     */
    public static MeasuredRun begun(MeasuredRun run, BelievedModel model) {
        return run.start()
                .filter(start -> start.deviations().stream().anyMatch(d -> d.isInfinite()))
                .map(start -> start.orElse(beginning(run, model.start())))
                .or(() -> underWay(run, model))
                .map(run::startingAt)
                .orElse(run);
    }

    /** What is known of turns that are not measured where others are. */
    private static Optional<KnownStart> underWay(MeasuredRun run, BelievedModel model) {
        boolean tellsSomeTurns =
                run.measures(Channel.ORIENTATION)
                        && run.frame(Channel.ORIENTATION) == Frame.WORLD
                        && !run.measures(Channel.ANGULAR_VELOCITY);
        if (run.start().isPresent() || !run.beginsMidway() || !tellsSomeTurns) {
            return Optional.empty();
        }
        List<Double> deviations =
                new ArrayList<>(Collections.nCopies(RigidMotion.SIZE, Double.POSITIVE_INFINITY));
        for (int axis = 0; axis < 3; axis++) {
            if (!run.measures(Channel.ORIENTATION, axis)) {
                deviations.set(3 + axis, TILT);
                deviations.set(9 + axis, TILTING);
            }
        }
        return Optional.of(new KnownStart(beginning(run, model.start()), deviations));
    }

    private static RigidMotion beginning(MeasuredRun run, RigidMotion otherwise) {
        return at(run, otherwise, 0, Math.min(BEGINNING, run.size() - 1));
    }

    private RigidMotion motion() {
        Quat axes =
                IntStream.rangeClosed(from, to)
                        .filter(run::isOriented)
                        .boxed()
                        .findFirst()
                        .flatMap(run::orientation)
                        .or(() -> run.orientation(from))
                        .orElse(otherwise.orientation());
        double[][] turn = new double[3][];
        for (int i = 0; i < 3; i++) {
            WeightedObservedPoints turns = turns(axes, i);
            int degree = turns.toList().size() < FEW ? 1 : DEGREE;
            turn[i] = polynomial(turns, degree, 0, otherwise.angularVelocity().component(i));
        }
        Quat oriented = still(axes).plus(change(column(turn, 0))).orientation();
        Vec3 carried = carried(oriented);
        double[][] place = new double[3][];
        for (int i = 0; i < 3; i++) {
            double there = otherwise.position().component(i);
            place[i] = polynomial(places(axes, i), DEGREE, there, carried.component(i));
        }
        Vec3 atPlace = column(place, 0);
        return new RigidMotion(
                atPlace,
                oriented,
                asMeasured(Channel.VELOCITY, oriented, column(place, 1)),
                asMeasured(Channel.ANGULAR_VELOCITY, oriented, column(turn, 1)));
    }

    /** The velocity along the body's axes as in the motion given. */
    private Vec3 carried(Quat orientation) {
        return orientation.rotate(otherwise.orientation().rotateInverse(otherwise.velocity()));
    }

    /** A velocity in the world's axes, along axes along which it was measured itself as it was. */
    private Vec3 asMeasured(Channel channel, Quat orientation, Vec3 otherwise) {
        boolean isAlongBody = run.frame(channel) == Frame.BODY;
        Vec3 own = isAlongBody ? orientation.rotateInverse(otherwise) : otherwise;
        Vec3 told =
                new Vec3(
                        first(channel, 0).orElse(own.x()),
                        first(channel, 1).orElse(own.y()),
                        first(channel, 2).orElse(own.z()));
        return isAlongBody ? orientation.rotate(told) : told;
    }

    /** The first number of a channel, as it need not be measured in each row. */
    private OptionalDouble first(Channel channel, int axis) {
        return IntStream.rangeClosed(from, Math.min(to, from + BEGINNING))
                .mapToDouble(k -> run.value(channel, k, axis))
                .filter(value -> !Double.isNaN(value))
                .findFirst();
    }

    /** A few at least, and no more once it has turned far: a path that winds is no parabola. */
    private WeightedObservedPoints places(Quat axes, int axis) {
        WeightedObservedPoints places = new WeightedObservedPoints();
        boolean hasTurned = false;
        for (int k = from; k <= to && !(hasTurned && places.toList().size() >= FEW); k++) {
            double place = run.value(Channel.POSITION, k, axis);
            if (!Double.isNaN(place)) {
                places.add(run.time(k) - run.time(from), place);
            }
            hasTurned |=
                    run.orientation(k)
                            .filter(q -> OrientationError.turn(axes, q).norm() > WINDING)
                            .isPresent();
        }
        return places;
    }

    /** Of samples that lack an angle of others these alone count, where there are any. */
    private WeightedObservedPoints turns(Quat axes, int axis) {
        WeightedObservedPoints turns = new WeightedObservedPoints();
        boolean isOriented = IntStream.rangeClosed(from, to).anyMatch(run::isOriented);
        for (int k = from; k <= to; k++) {
            if (isOriented && !run.isOriented(k)) {
                continue;
            }
            double time = run.time(k) - run.time(from);
            Optional<Vec3> turn = run.orientation(k).map(q -> OrientationError.turn(axes, q));
            if (turn.isPresent() && turn.get().norm() > MOST_TURN) {
                break;
            }
            turn.ifPresent(t -> turns.add(time, t.component(axis)));
        }
        return turns;
    }

    /** Value and slope where the points begin; as given where there are none. */
    private static double[] polynomial(
            WeightedObservedPoints points, int most, double value, double slope) {
        int count = points.toList().size();
        double[] all = {value, slope, 0};
        if (count > 0) {
            int degree = Math.min(most, count - 1);
            double[] fitted = PolynomialCurveFitter.create(degree).fit(points.toList());
            System.arraycopy(fitted, 0, all, 0, fitted.length);
        }
        return all;
    }

    private static RigidMotion still(Quat orientation) {
        return new RigidMotion(Vec3.ZERO, orientation, Vec3.ZERO, Vec3.ZERO);
    }

    private static double[] change(Vec3 turn) {
        return new double[] {0, 0, 0, turn.x(), turn.y(), turn.z(), 0, 0, 0, 0, 0, 0};
    }

    private static Vec3 column(double[][] rows, int column) {
        return new Vec3(rows[0][column], rows[1][column], rows[2][column]);
    }
}
