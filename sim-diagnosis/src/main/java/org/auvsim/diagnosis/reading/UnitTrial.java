package org.auvsim.diagnosis.reading;

import org.apache.commons.math3.fitting.PolynomialCurveFitter;
import org.apache.commons.math3.fitting.WeightedObservedPoints;
import org.apache.commons.math3.stat.regression.SimpleRegression;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** A part of a run by the model, begun as measured, with its positions in several units. */
final class UnitTrial {
    /** Samples of a part at least. */
    static final int FEWEST = 12;

    /** So many of them tell how a path bends. */
    private static final int MOST = 60;

    /** Steps between samples of noise alone are 2 (von Neumann 1941), of a path that bends 0. */
    private static final double OF_NOISE = 1;

    /** So many steps of the model tell as much as more. */
    private static final int STEPS = 1500;

    /** Up to this one of them they tell how it begins. */
    private static final int BEGINNING = 6;

    /** Nothing is suspected. */
    static final ModelUnits.Suspicion AS_TOLD = new ModelUnits.Suspicion(List.of(), 1);

    private final BelievedModel model;
    private final MeasuredRun run;
    private final int[] samples;
    private final RigidMotion begin;
    private final RigidMotion[] fromRest;
    private final List<ModelUnits.Suspicion> hypotheses = new ArrayList<>();
    private final List<List<Bend>> bends = new ArrayList<>();

    /**
     * Squares of how much paths bend along an axis (m^2).
     *
     * @param told as measured
     * @param simulated begun as measured
     * @param both the product of these two
     * @param fromRest simulated from rest
     * @param misfit of measured less simulated
     * @param steps squares of the differences from one measured sample to the next
     */
    private record Bend(
            double told,
            double simulated,
            double both,
            double fromRest,
            double misfit,
            double steps) {
        Bend plus(Bend o) {
            return new Bend(
                    told + o.told,
                    simulated + o.simulated,
                    both + o.both,
                    fromRest + o.fromRest,
                    misfit + o.misfit,
                    steps + o.steps);
        }

        /** Squares of noise, as steps tell: 2 of each (von Neumann 1941). */
        double noise() {
            return steps / 2;
        }

        /** What forces do, moving or at rest. */
        double forces() {
            return Math.max(simulated, fromRest);
        }
    }

    private UnitTrial(BelievedModel model, MeasuredRun run, int[] samples) {
        this.model = model;
        this.run = run;
        this.samples = samples;
        this.begin = beginning();
        this.fromRest =
                Ensemble.simulate(
                        model,
                        run,
                        samples,
                        List.of(new Ensemble.Entrant(model.variant(), still(begin))))[0];
    }

    /** The part between two samples, as the model does from rest. */
    static UnitTrial of(BelievedModel model, MeasuredRun run, int from, int to) {
        double longest = STEPS * model.scenario().timeStep().delta();
        int last = to;
        while (last > from + FEWEST && run.time(last) - run.time(from) > longest) {
            last--;
        }
        int[] placed = placed(run, from, last);
        int count = Math.min(MOST, placed.length);
        int[] samples = new int[count];
        for (int i = 0; i < count; i++) {
            samples[i] = placed[(int) ((long) i * (placed.length - 1) / (count - 1))];
        }
        return new UnitTrial(model, run, samples);
    }

    /** Samples that have a place, which other sensors may tell far more often; or all. */
    private static int[] placed(MeasuredRun run, int from, int to) {
        int[] placed = IntStream.rangeClosed(from, to).filter(k -> isPlaced(run, k)).toArray();
        return placed.length < FEWEST ? IntStream.rangeClosed(from, to).toArray() : placed;
    }

    private static boolean isPlaced(MeasuredRun run, int sample) {
        return IntStream.range(0, 3)
                .filter(axis -> run.measures(Channel.POSITION, axis))
                .noneMatch(axis -> Double.isNaN(run.value(Channel.POSITION, sample, axis)));
    }

    /** The same as it is told and by some hypotheses, from rest and as measured. */
    UnitTrial of(List<ModelUnits.Suspicion> some) {
        hypotheses.add(AS_TOLD);
        hypotheses.addAll(some);
        List<Ensemble.Entrant> entrants = new ArrayList<>();
        for (ModelUnits.Suspicion h : hypotheses) {
            RigidMotion moving = scaled(begin, h);
            entrants.add(new Ensemble.Entrant(model.variant(), moving));
            entrants.add(new Ensemble.Entrant(model.variant(), still(moving)));
        }
        RigidMotion[][] motions = Ensemble.simulate(model, run, samples, entrants);
        for (int h = 0; h < hypotheses.size(); h++) {
            bends.add(bends(hypotheses.get(h), motions[2 * h], motions[2 * h + 1]));
        }
        return this;
    }

    private static RigidMotion still(RigidMotion moving) {
        return new RigidMotion(moving.position(), moving.orientation(), Vec3.ZERO, Vec3.ZERO);
    }

    /** Whether a hypothesis was tried. */
    boolean has(ModelUnits.Suspicion h) {
        return hypotheses.contains(h);
    }

    /** How many times as far it goes along axes as the model from rest; infinite if that rests. */
    double farther(Collection<Integer> axes) {
        double measured = 0;
        double simulated = 0;
        for (int axis : axes) {
            double[] least = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
            double[] most = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
            for (int i = 0; i < samples.length; i++) {
                double told = run.value(Channel.POSITION, samples[i], axis);
                double model = fromRest[i].position().component(axis);
                if (!Double.isNaN(told)) {
                    least[0] = Math.min(least[0], told);
                    most[0] = Math.max(most[0], told);
                    least[1] = Math.min(least[1], model);
                    most[1] = Math.max(most[1], model);
                }
            }
            measured = Math.max(measured, most[0] - least[0]);
            simulated = Math.max(simulated, most[1] - least[1]);
        }
        return measured / simulated;
    }

    private static double factor(ModelUnits.Suspicion h, int axis) {
        return h.axes().contains(axis) ? h.factor() : 1;
    }

    private static RigidMotion scaled(RigidMotion m, ModelUnits.Suspicion h) {
        return new RigidMotion(
                scaled(m.position(), h),
                m.orientation(),
                scaled(m.velocity(), h),
                m.angularVelocity());
    }

    private static Vec3 scaled(Vec3 v, ModelUnits.Suspicion h) {
        return new Vec3(v.x() * factor(h, 0), v.y() * factor(h, 1), v.z() * factor(h, 2));
    }

    /** Position and velocity by a parabola through the first samples. */
    private RigidMotion beginning() {
        Vec3 usual = model.variant().body().position();
        double[] position = {usual.x(), usual.y(), usual.z()};
        double[] velocity = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            WeightedObservedPoints points = new WeightedObservedPoints();
            for (int k = samples[0]; k <= samples[BEGINNING]; k++) {
                double value = run.value(Channel.POSITION, k, axis);
                if (!Double.isNaN(value)) {
                    points.add(run.time(k) - run.time(samples[0]), value);
                }
            }
            if (points.toList().size() > 3) {
                double[] parabola = PolynomialCurveFitter.create(2).fit(points.toList());
                position[axis] = parabola[0];
                velocity[axis] = parabola[1];
            }
        }
        return new RigidMotion(
                new Vec3(position[0], position[1], position[2]),
                atBeginning()
                        .flatMap(k -> run.orientation(k).stream())
                        .findFirst()
                        .orElse(model.variant().body().orientation()),
                new Vec3(velocity[0], velocity[1], velocity[2]),
                turning());
    }

    private Stream<Integer> atBeginning() {
        return IntStream.rangeClosed(samples[0], samples[BEGINNING]).boxed();
    }

    /** As it is measured, or by how the orientation changes; 0 if neither tells. */
    private Vec3 turning() {
        boolean isOfBody = run.frame(Channel.ANGULAR_VELOCITY) == Frame.BODY;
        List<Integer> turned = atBeginning().filter(k -> run.orientation(k).isPresent()).toList();
        Optional<Vec3> measured =
                atBeginning()
                        .flatMap(k -> run.vector(Channel.ANGULAR_VELOCITY, k).stream())
                        .findFirst();
        if (turned.isEmpty()) {
            return isOfBody ? Vec3.ZERO : measured.orElse(Vec3.ZERO);
        }
        Quat before = run.orientation(turned.getFirst()).orElseThrow();
        if (measured.isPresent()) {
            return isOfBody ? before.rotate(measured.get()) : measured.get();
        }
        Quat after = run.orientation(turned.getLast()).orElseThrow();
        Quat turn = after.times(before.conjugate());
        Vec3 sine = new Vec3(turn.x(), turn.y(), turn.z());
        double size = sine.norm();
        double angle = 2 * StrictMath.atan2(size, Math.abs(turn.w())) * Math.signum(turn.w());
        double time = run.time(turned.getLast()) - run.time(turned.getFirst());
        return size > 0 && time > 0 ? sine.times(angle / size / time) : Vec3.ZERO;
    }

    private List<Bend> bends(ModelUnits.Suspicion h, RigidMotion[] moving, RigidMotion[] still) {
        List<Bend> all = new ArrayList<>();
        for (int axis = 0; axis < 3; axis++) {
            SimpleRegression[] lines = new SimpleRegression[4];
            Arrays.setAll(lines, _ -> new SimpleRegression());
            SimpleRegression both = new SimpleRegression();
            for (int i = 0; i < samples.length; i++) {
                double time = run.time(samples[i]) - run.time(samples[0]);
                double told = factor(h, axis) * run.value(Channel.POSITION, samples[i], axis);
                double simulated = moving[i].position().component(axis);
                if (!Double.isNaN(told)) {
                    lines[0].addData(time, told);
                    lines[1].addData(time, simulated);
                    lines[2].addData(time, still[i].position().component(axis));
                    lines[3].addData(time, told - simulated);
                    both.addData(time, told + simulated);
                }
            }
            double[] squares = Arrays.stream(lines).mapToDouble(UnitTrial::besideLine).toArray();
            double product = (besideLine(both) - squares[0] - squares[1]) / 2;
            double steps = steps(h, axis, lines[0]);
            all.add(new Bend(squares[0], squares[1], product, squares[2], squares[3], steps));
        }
        return all;
    }

    /** Sum of squares of the differences between samples of what is left beside a line. */
    private double steps(ModelUnits.Suspicion h, int axis, SimpleRegression line) {
        double sum = 0;
        double before = Double.NaN;
        for (int sample : samples) {
            double told = factor(h, axis) * run.value(Channel.POSITION, sample, axis);
            double left = told - line.predict(run.time(sample) - run.time(samples[0]));
            if (!Double.isNaN(left - before)) {
                sum += (left - before) * (left - before);
            }
            before = left;
        }
        return sum;
    }

    /** Sum of squares of what is left beside a straight line. */
    private static double besideLine(SimpleRegression line) {
        return line.getN() < FEWEST / 2 ? Double.NaN : Math.max(0, line.getSumSquaredErrors());
    }

    private Bend bend(ModelUnits.Suspicion h, Collection<Integer> axes) {
        List<Bend> of = bends.get(hypotheses.indexOf(h));
        return axes.stream().map(of::get).reduce(Bend::plus).orElseThrow();
    }

    /**
     * Whether paths bend alike along axes, and one no more than so many times the other; then it
     * may be that forces are known that well.
     *
     * @param together least correlation
     */
    boolean areAlike(
            ModelUnits.Suspicion h, Collection<Integer> axes, double together, double times) {
        Bend of = bend(h, axes);
        double size = Math.sqrt(of.told() / of.simulated());
        return of.both() >= together * Math.sqrt(of.told() * of.simulated())
                && size <= times
                && size >= 1 / times;
    }

    /** Whether what was measured along axes bends no more than noise does. */
    boolean isNoise(Collection<Integer> axes) {
        Bend of = bend(AS_TOLD, axes);
        return of.steps() > OF_NOISE * of.told();
    }

    /** The misfit along axes, as a share of what forces do; infinite where that is lost. */
    double misfit(ModelUnits.Suspicion h, Collection<Integer> axes) {
        Bend of = bend(h, axes);
        return share(of.misfit(), of);
    }

    /** The same of what is told, less what noise leaves. */
    double beyondNoise(Collection<Integer> axes) {
        Bend of = bend(AS_TOLD, axes);
        return share(Math.max(0, of.misfit() - of.noise()), of);
    }

    private static double share(double squares, Bend of) {
        double share = Math.sqrt(squares / of.forces());
        return Double.isNaN(share) ? Double.POSITIVE_INFINITY : share;
    }

    /** What forces do along an axis by a hypothesis (m^2). */
    double forces(ModelUnits.Suspicion h, int axis) {
        return bend(h, List.of(axis)).forces();
    }
}
