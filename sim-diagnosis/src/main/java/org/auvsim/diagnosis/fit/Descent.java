package org.auvsim.diagnosis.fit;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * Goes down to where a hypothesis fits whole runs best, by steps that are damped the more the less
 * the last ones led where they should (Levenberg-Marquardt: Marquardt 1963). Derivatives are taken
 * anew where those there were did not foretell what is missed.
 */
public final class Descent {
    /** A share of the cost that is not worth a step. */
    private static final double ENOUGH = 1e-4;

    /** The same of what is believed. */
    private static final double ENOUGH_AT_LAST = 1e-6;

    /**
     * The remaining steps are assumed to gain at most this many times what the last one did; with
     * fewer, long valleys are missed.
     */
    private static final int MOST_HOPED = 40;

    /** What derivatives foretold less wrong than this (squares of standard deviations) is sure. */
    private static final double SURE = 0.01;

    /** Steps that gain less of what they should are tried in other ways, too. */
    private static final double POOR = 0.05;

    private static final List<Double> SHARES = List.of(1.0 / 3, 1.0 / 9, 1.0 / 27, 1.0 / 81);

    private Place best;
    private Optional<Tangents> tangents = Optional.empty();
    private double enough = ENOUGH;
    private Function<Simulated, Tangents> derivatives = Tangents::of;
    private final Damping ofParameters = new Damping(Step::damped);
    private final Damping ofAll = new Damping(Step::held);

    private Descent(Place start) {
        this.best = start;
    }

    /** From a fit of one window a run. */
    public static Descent of(Fit start) {
        return new Descent(Place.of(start.asSeen()));
    }

    /** The same of one that was judged. */
    public static Descent of(Judged start) {
        Fit seen = start.fit().asSeen();
        boolean isTheSame = seen.equals(start.fit());
        return new Descent(isTheSame ? Place.of(start) : Place.of(seen));
    }

    /** The same, derivatives known of the neighbourhood. */
    Descent near(Tangents known) {
        tangents = Optional.of(known);
        return this;
    }

    /** The same, to the very end of long valleys. */
    public Descent finely() {
        enough = ENOUGH_AT_LAST;
        derivatives = Tangents::close;
        return this;
    }

    /** So many steps, or as many as help. */
    public Judged steps(int most) {
        return steps(most, Double.POSITIVE_INFINITY, Course.UNHEARD);
    }

    /**
     * So many steps, or as many as help; given up where a score is out of reach, as far as the last
     * step tells, and once it was told to stop.
     */
    public Judged steps(int most, double score, Course course) {
        for (int s = 0; s < most && course.goesOn(); s++) {
            Tangents here =
                    tangents.map(t -> t.at(best.at()))
                            .orElseGet(() -> derivatives.apply(best.at()));
            Optional<Step> step = Step.of(best.at().fit(), here, 1);
            if (step.isEmpty()) {
                break;
            }
            Place next = next(step.get(), here.off() == 0);
            double gain = best.cost() - next.cost();
            double hoped = MOST_HOPED * (best.judged().score() - next.judged().score());
            best = next;
            boolean hasArrived = !isWorthIt(gain) && here.off() < SURE;
            if (hasArrived || !(best.judged().score() - hoped < score)) {
                break;
            }
            tangents = isWorthIt(gain) ? Optional.of(here) : Optional.empty();
        }
        return best.judged();
    }

    /**
     * Where a step leads, as short as it needs to be; the same place if it leads nowhere.
     *
     * @param isExact whether its derivatives were taken here
     */
    private Place next(Step step, boolean isExact) {
        Damping first = step.hasParameters() ? ofParameters : ofAll;
        Place reached = first.next(best, step, isExact, worth());
        double promise = best.cost() - step.least();
        boolean isPoor = best.cost() - reached.cost() < POOR * promise;
        if (!isExact || !isPoor || !isWorthIt(promise)) {
            return reached;
        }
        Place held = step.hasParameters() ? ofAll.next(best, step, true, worth()) : reached;
        return Stream.of(reached, held, shorter(step))
                .min(Comparator.comparingDouble(Place::cost))
                .orElseThrow();
    }

    private boolean isWorthIt(double gain) {
        return gain > worth();
    }

    /** What a step must gain. */
    private double worth() {
        return enough * best.cost();
    }

    private Place shorter(Step step) {
        return SHARES.stream()
                .map(share -> Place.of(step.end(share)))
                .filter(tried -> tried.cost() < best.cost())
                .findFirst()
                .orElse(best);
    }
}
