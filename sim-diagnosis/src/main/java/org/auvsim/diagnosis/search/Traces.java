package org.auvsim.diagnosis.search;

import org.apache.commons.math3.exception.MathIllegalArgumentException;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.fit.Gram;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.result.Identifiability;
import org.auvsim.diagnosis.result.Identifiability.Confusion;
import org.auvsim.diagnosis.result.Identifiability.Smallest;

import java.util.Arrays;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/**
 * How alike the traces are that causes leave in the data: the smallest angle between the subspaces
 * of their columns (Bjorck &amp; Golub 1973), the starts projected out.
 */
public final class Traces {
    /** Traces at a larger angle (degrees) are not worth a word. */
    private static final double ALIKE = 25;

    /** Those at a smaller angle (degrees) may be taken for one another. */
    private static final double NEARLY_THE_SAME = 10;

    private static final int MOST = 12;

    /** A cause a hundred times its telling size that stays below noise leaves no trace. */
    private static final double UNSEEN = 0.01;

    /** What its telling size leaves below this (in standard deviations) is rounding. */
    private static final double ROUNDING = 1e-9;

    /** What would have to be so many times its telling size hardly shows. */
    private static final double MOST_SCALES = 100;

    /** Noise takes so many standard deviations from a trace in 3 of 100 measurements. */
    private static final double NOISE = 2;

    private static final double RIDGE = 1e-9;

    private final Hypothesis beside;
    private final Gram gram;
    private final List<Seed> seeds;
    private final ToDoubleFunction<Cause> price;

    /**
     * Of seeds beside a hypothesis, whose own numbers have the first columns.
     *
     * @param price what a cause must gain to be believed
     */
    Traces(Hypothesis beside, Gram gram, List<Seed> seeds, ToDoubleFunction<Cause> price) {
        this.beside = beside;
        this.gram = gram;
        this.seeds = seeds;
        this.price = price;
    }

    /** Of no other causes. */
    static Traces none(Hypothesis beside) {
        return new Traces(beside, new Gram(new double[1][1]), List.of(), Cause::price);
    }

    /** What is confused with the causes that were found, and what could not have been seen. */
    public Identifiability identifiability(List<Cause> found) {
        Map<List<Cause>, Confusion> confusions = new LinkedHashMap<>();
        List<Seed> telling =
                seeds.stream().filter(s -> s.cause().isAmong(found) || leaves(s, UNSEEN)).toList();
        for (Seed seed : telling) {
            if (!found.isEmpty() && !seed.cause().isAmong(found)) {
                continue;
            }
            for (Seed other : telling) {
                boolean isOnce = other.cause().isAmong(found) || found.isEmpty();
                if (other.cause().equals(seed.cause())
                        || (isOnce && other.first() < seed.first())) {
                    continue;
                }
                Nearest nearest = nearest(seed.columns(), other.columns());
                if (nearest.angle() < ALIKE) {
                    confusions.merge(
                            List.of(seed.cause(), other.cause()),
                            new Confusion(
                                    seed.cause().label(),
                                    number(seed, nearest.one()),
                                    other.cause().label(),
                                    number(other, nearest.other()),
                                    nearest.angle()),
                            (one, more) -> more.angle() < one.angle() ? more : one);
                }
            }
        }
        List<Confusion> pairs =
                confusions.values().stream()
                        .sorted(Comparator.comparingDouble(Confusion::angle))
                        .limit(MOST)
                        .toList();
        Set<Cause> seen = leaving(UNSEEN);
        Set<Cause> observable = leaving(ROUNDING);
        seen.addAll(found);
        return new Identifiability(
                pairs,
                labels(cause -> observable.contains(cause) && !cause.isAmong(List.copyOf(seen))),
                labels(cause -> !observable.contains(cause) && !cause.isAmong(List.copyOf(seen))),
                smallest());
    }

    /**
     * Of each cause that is not there the numbers that would be found, each alone: where, of the
     * guesses at it, that number shows best.
     */
    private List<Smallest> smallest() {
        Map<List<Object>, Smallest> smallest = new LinkedHashMap<>();
        for (Seed seed : seeds) {
            Cause cause = seed.cause();
            if (cause.isAmong(beside.causes())) {
                continue;
            }
            double trace = NOISE + Math.sqrt(price.applyAsDouble(cause) + OneOrTwo.DOUBTFUL);
            for (int c = 0; c < seed.columns().length; c++) {
                Parameter of = seed.parameters().get(c);
                double norm = Math.sqrt(besideOwn(seed.columns()[c]));
                double size = trace / norm;
                boolean isSeen = size < MOST_SCALES * of.scale();
                if (isSeen && size < Math.max(of.highest(), -of.lowest())) {
                    smallest.merge(
                            List.of(cause, of.name()),
                            new Smallest(cause.name(), of.name(), of.unit(), size),
                            (one, other) -> one.size() <= other.size() ? one : other);
                }
            }
        }
        return List.copyOf(smallest.values());
    }

    /** The square of what a column leaves that the hypothesis's own numbers cannot make up for. */
    private double besideOwn(int column) {
        double square = gram.product(column, column);
        int[] own = telling(IntStream.range(0, beside.size()).toArray());
        if (own.length == 0) {
            return square;
        }
        RealMatrix with = matrix(own, new int[] {column});
        try {
            RealMatrix made = new LUDecomposition(root(own)).getSolver().solve(with);
            double norm = made.getFrobeniusNorm();
            return Math.max(0, square - norm * norm);
        } catch (MathIllegalArgumentException e) {
            return square; // own numbers that leave no trace make up for nothing
        }
    }

    /** Causes that leave nearly the same trace as one of the hypothesis, as that was found. */
    List<Cause> alike(Cause cause) {
        int[] columns = columns(cause);
        Set<Cause> alike = new LinkedHashSet<>();
        for (Seed other : seeds) {
            if (!other.cause().isFormOf(cause)
                    && nearest(columns, other.columns()).angle() < NEARLY_THE_SAME) {
                alike.add(other.cause());
            }
        }
        return List.copyOf(alike);
    }

    private int[] columns(Cause cause) {
        int first = 0;
        for (Cause of : beside.causes()) {
            int size = of.parameters().size();
            if (of.equals(cause)) {
                return IntStream.range(first, first + size).toArray();
            }
            first += size;
        }
        return new int[0];
    }

    private List<String> labels(Predicate<Cause> which) {
        return seeds.stream().map(Seed::cause).distinct().filter(which).map(Cause::label).toList();
    }

    /** Causes some guess of which leaves more than so many standard deviations. */
    private Set<Cause> leaving(double trace) {
        Set<Cause> leaving = new HashSet<>();
        seeds.stream().filter(s -> leaves(s, trace)).map(Seed::cause).forEach(leaving::add);
        return leaving;
    }

    /** Whether a number at its telling size leaves more than so many standard deviations. */
    private boolean leaves(Seed seed, double trace) {
        for (int c = 0; c < seed.columns().length; c++) {
            int p = seed.guess().columns().get(c);
            double scale = seed.cause().parameters().get(p).scale();
            if (gram.norm(seed.columns()[c]) * scale > trace) {
                return true;
            }
        }
        return false;
    }

    /** Those that leave a trace: of what is held, numbers along some axes leave none. */
    private int[] telling(int[] columns) {
        return Arrays.stream(columns).filter(c -> gram.product(c, c) > 0).toArray();
    }

    /** The name of the number that a column of a seed is of. */
    private static String number(Seed seed, int column) {
        return seed.parameters().get(column - seed.first()).name();
    }

    /**
     * The smallest angle between traces, and the columns that are nearest to where it is.
     *
     * @param angle degrees; 90 where one of them leaves no trace
     */
    private record Nearest(double angle, int one, int other) {
        static final Nearest NONE = new Nearest(90, -1, -1);
    }

    private Nearest nearest(int[] ofOne, int[] ofOther) {
        int[] a = telling(ofOne);
        int[] b = telling(ofOther);
        if (a.length == 0 || b.length == 0) {
            return Nearest.NONE;
        }
        RealMatrix between = matrix(a, b);
        try {
            RealMatrix one = root(a);
            RealMatrix other = root(b);
            RealMatrix cosines =
                    new LUDecomposition(one)
                            .getSolver()
                            .solve(between)
                            .multiply(
                                    new LUDecomposition(other)
                                            .getSolver()
                                            .getInverse()
                                            .transpose());
            SingularValueDecomposition directions = new SingularValueDecomposition(cosines);
            double cosine = Math.min(1, directions.getSingularValues()[0]);
            return new Nearest(
                    Math.toDegrees(StrictMath.acos(cosine)),
                    a[along(directions.getU().getColumnVector(0), one)],
                    b[along(directions.getV().getColumnVector(0), other)]);
        } catch (MathIllegalArgumentException e) {
            return Nearest.NONE; // no trace, so nothing to be confused with
        }
    }

    /** Which of some columns, the rows here, is most along a direction. */
    private static int along(RealVector direction, RealMatrix columns) {
        int best = 0;
        double most = -1;
        for (int i = 0; i < columns.getRowDimension(); i++) {
            double cosine = Math.abs(columns.getRowVector(i).cosine(direction));
            if (cosine > most) {
                most = cosine;
                best = i;
            }
        }
        return best;
    }

    private RealMatrix root(int[] columns) {
        RealMatrix own = matrix(columns, columns);
        for (int i = 0; i < columns.length; i++) {
            own.addToEntry(i, i, RIDGE * own.getEntry(i, i));
        }
        return new CholeskyDecomposition(
                        own, CholeskyDecomposition.DEFAULT_RELATIVE_SYMMETRY_THRESHOLD, 0)
                .getL();
    }

    private RealMatrix matrix(int[] rows, int[] columns) {
        RealMatrix matrix = new Array2DRowRealMatrix(rows.length, columns.length);
        for (int i = 0; i < rows.length; i++) {
            for (int j = 0; j < columns.length; j++) {
                matrix.setEntry(i, j, gram.product(rows[i], columns[j]));
            }
        }
        return matrix;
    }
}
