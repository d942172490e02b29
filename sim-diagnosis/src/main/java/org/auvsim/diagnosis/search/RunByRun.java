package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Descent;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Refinement;
import org.auvsim.diagnosis.fit.Uncertainty;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.Numbers;
import org.auvsim.diagnosis.shooting.Stepping;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.StringJoiner;

/**
 * Whether runs that nothing explains together are explained by one cause each by itself, of other
 * numbers: then something changed between them, as a vehicle that was loaded or fouled.
 */
public final class RunByRun {
    /** Numbers of two runs differ for sure by so many of their standard deviations. */
    private static final double SURELY = 5;

    private final Stepping stepping;
    private final List<Misses> data;
    private final Noise noise;
    private final Course course;

    /** Of some runs. */
    public RunByRun(Stepping stepping, List<Misses> data, Noise noise, Course course) {
        this.stepping = stepping;
        this.data = List.copyOf(data);
        this.noise = noise;
        this.course = course;
    }

    /** What a run says of a cause's numbers. */
    private record Told(String run, List<Quantity> numbers, List<Double> deviations) {
        /** By how many deviations a number differs from another run's. */
        double apart(Told other, int number) {
            double deviation =
                    StrictMath.hypot(deviations.get(number), other.deviations.get(number));
            double apart = numbers.get(number).value() - other.numbers.get(number).value();
            return Double.isFinite(deviation) ? Math.abs(apart) / deviation : 0;
        }

        String text(int number) {
            return "%s in %s"
                    .formatted(
                            Numbers.uncertain(numbers.get(number).value(), deviations.get(number)),
                            run);
        }
    }

    /**
     * What one cause says of each run.
     *
     * @param apart the number of which two runs tell most differently
     */
    private record Each(Hypothesis cause, List<Told> told, int apart, double score) {}

    /**
     * What is told of the cause that does best, its numbers paid for; empty if none does.
     *
     * @param causes single ones, with numbers to begin at
     */
    public Optional<String> notice(List<Hypothesis> causes) {
        return causes.stream()
                .flatMap(cause -> each(cause).stream())
                .min(Comparator.comparingDouble(Each::score))
                .map(RunByRun::words);
    }

    /** Empty where a run is not explained, or all are by the same numbers. */
    private Optional<Each> each(Hypothesis cause) {
        List<Told> all = new ArrayList<>();
        double score = 0;
        for (Misses run : data) {
            if (!course.goesOn()) {
                return Optional.empty();
            }
            Judged alone = alone(cause, run);
            if (!alone.isWhite()) {
                return Optional.empty();
            }
            score += alone.score();
            all.add(
                    new Told(
                            run.run().name(),
                            cause.causes().getFirst().quantities(numbers(alone)),
                            new Uncertainty(alone).deviations().getFirst()));
        }
        double paid = score;
        return furthestApart(all).map(number -> new Each(cause, all, number, paid));
    }

    private static double[] numbers(Judged of) {
        return of.fit().hypothesis().theta().getFirst();
    }

    private Judged alone(Hypothesis cause, Misses run) {
        Fit followed = Following.of(stepping, cause, List.of(run), noise, course);
        return Descent.of(Refinement.approach(followed, 1))
                .steps(Tournament.TO_THE_END, Double.POSITIVE_INFINITY, course);
    }

    /** The number of which two runs tell most differently; empty if none do for sure. */
    private static Optional<Integer> furthestApart(List<Told> all) {
        double furthest = SURELY;
        Optional<Integer> number = Optional.empty();
        for (int i = 0; i < all.getFirst().numbers().size(); i++) {
            for (Told one : all) {
                for (Told other : all) {
                    if (one.apart(other, i) > furthest) {
                        furthest = one.apart(other, i);
                        number = Optional.of(i);
                    }
                }
            }
        }
        return number;
    }

    private static String words(Each of) {
        Quantity number = of.told().getFirst().numbers().get(of.apart());
        StringJoiner runs = new StringJoiner(", ");
        of.told().forEach(told -> runs.add(told.text(of.apart())));
        return "each run by itself is explained by %s, but not by the same: %s%s is %s; something changed between the runs, so diagnose those together that agree"
                .formatted(
                        of.cause().causes().getFirst().label(),
                        number.name(),
                        number.unit().equals("1") ? "" : " (" + number.unit() + ")",
                        runs);
    }
}
