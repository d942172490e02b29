package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Descent;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Refinement;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;

/** Sets of causes that were fitted and judged, and what lets more of them compete. */
public final class Tried {
    private final List<Judged> judged = new ArrayList<>();
    private final Noise noise;
    private final Course course;
    private final UnaryOperator<Judged> unaliased;

    /** Nothing yet but the model as it is believed. */
    public Tried(Judged none, Noise noise, Course course) {
        this(none, noise, course, UnaryOperator.identity());
    }

    /**
     * Nothing yet but the model as it is believed.
     *
     * @param unaliased what is better than a set, or the set, at aliases of its frequencies
     */
    Tried(Judged none, Noise noise, Course course, UnaryOperator<Judged> unaliased) {
        judged.add(none);
        this.noise = noise;
        this.course = course;
        this.unaliased = unaliased;
    }

    /** The best of all, if it is better than what was found otherwise. */
    Judged tournament(List<Screen.Start> starts, Judged otherwise, double from, double to) {
        List<Judged> last = last(starts, otherwise, from, to);
        return best(last, otherwise);
    }

    /** The same, each of the last ones from new starts of the runs, too. */
    Judged tournamentAnew(List<Screen.Start> starts, Judged otherwise, double from, double to) {
        List<Judged> last = last(starts, otherwise, from, to);
        return best(last.stream().map(this::anew).toList(), best(last, otherwise));
    }

    private List<Judged> last(List<Screen.Start> starts, Judged otherwise, double from, double to) {
        if (starts.isEmpty()) {
            return List.of();
        }
        List<Judged> last =
                new Tournament(otherwise, noise, course, from, to)
                        .last(starts).stream().map(unaliased).toList();
        judged.addAll(last);
        return last;
    }

    /** The best of some, if it is better than what was found otherwise. */
    static Judged best(List<Judged> of, Judged otherwise) {
        return of.stream()
                .filter(j -> j.score() < otherwise.score())
                .min(Comparator.comparingDouble(Judged::score))
                .orElse(otherwise);
    }

    /**
     * The same from new starts of the runs, if it misses something and less from there: without its
     * causes starts were led astray, and may not find back.
     */
    public Judged begunAnew(Judged best) {
        return best.isNone() || best.isWhite() ? best : best(List.of(anew(best)), best);
    }

    /** With all that its causes can do. */
    Judged whole(Judged best) {
        return freed(begunAnew(best));
    }

    /** With more numbers of its causes, if it misses something and less by them. */
    Judged freed(Judged best) {
        List<MeasuredRun> runs = best.fit().data().stream().map(Misses::run).toList();
        Judged freest = best;
        for (int c = 0; c < best.size(); c++) {
            Fit fit = freest.fit();
            for (Hypothesis freed : fit.hypothesis().freed(c, runs)) {
                if (!freest.isWhite() && course.goesOn()) {
                    freest =
                            best(List.of(toTheEnd(fit.with(freed, fit.windows()), freest)), freest);
                }
            }
        }
        return freest;
    }

    private Judged toTheEnd(Fit begun, Judged best) {
        double toBeat = best.score() + Tournament.BESIDE;
        Judged end = Descent.of(begun).steps(Tournament.TO_THE_END, toBeat, course);
        judged.add(end);
        return end;
    }

    private Judged anew(Judged of) {
        if (!course.goesOn()) {
            return of;
        }
        return toTheEnd(Following.anew(of.fit(), noise, course), of);
    }

    /**
     * The same, brought to the very end: from where it is, from new starts of the runs, and from
     * windows that follow them. Where something sticks or starts hardly matter there are several
     * ends.
     */
    Judged settled(Judged best) {
        Judged settled = finest(best);
        if (!course.goesOn()) {
            return settled;
        }
        Fit of = settled.fit();
        Fit followed = Following.of(of.stepping(), of.hypothesis(), of.data(), noise, course);
        List<Judged> others =
                List.of(
                        finest(Judged.of(Following.anew(of, noise, course))),
                        finest(Refinement.approach(followed, 1)));
        return best(others, settled);
    }

    private Judged finest(Judged near) {
        Judged finest =
                Descent.of(near)
                        .finely()
                        .steps(Tournament.TO_THE_END, Double.POSITIVE_INFINITY, course);
        judged.add(finest);
        return finest;
    }

    /**
     * Without the causes that are not worth their price. Even one alone may not be: it was begun
     * from other starts than the model without it.
     */
    Judged pruned(Judged start) {
        Judged best = start;
        boolean goesOn = true;
        while (goesOn && course.goesOn()) {
            goesOn = false;
            Hypothesis hypothesis = best.fit().hypothesis();
            for (int c = 0; c < hypothesis.causes().size(); c++) {
                Fit fewer = best.fit().with(hypothesis.without(c), best.fit().windows());
                Judged without = toTheEnd(fewer, best);
                if (without.score() < best.score()) {
                    best = without;
                    goesOn = true;
                    break;
                }
            }
        }
        return best;
    }

    /** The best cause alone; none if none was fitted alone. */
    Hypothesis strongest() {
        return judged.stream()
                .filter(j -> j.size() == 1)
                .min(Comparator.comparingDouble(Judged::score))
                .map(j -> j.fit().hypothesis())
                .orElse(Hypothesis.NONE);
    }

    /** Whether a cause beside others was judged, and fitted as well as that. */
    boolean has(Hypothesis others, Cause cause, double score) {
        Hypothesis of = others.and(cause, new double[0]);
        return judged.stream()
                .filter(j -> j.score() < score)
                .anyMatch(j -> j.fit().hypothesis().hasCausesOf(of));
    }

    /**
     * Takes what was found for judged under the names of specific causes, too, where these make the
     * very same model of the same numbers: a clock that is off tells what a late sensor does.
     */
    void underSpecificNames(Judged found, List<Cause> library) {
        Fit fit = found.fit();
        Hypothesis of = fit.hypothesis();
        for (int c = 0; c < of.causes().size(); c++) {
            int place = c;
            if (of.causes().get(c).isGeneric()) {
                library.stream()
                        .filter(cause -> !cause.isGeneric())
                        .map(cause -> of.with(place, cause))
                        .filter(named -> makesTheSame(named, fit))
                        .map(named -> fit.with(named, fit.windows()))
                        .map(named -> Judged.of(named, found.outcome()))
                        .forEach(judged::add);
            }
        }
    }

    private static boolean makesTheSame(Hypothesis named, Fit as) {
        return named.makesSense() && named.in(as.stepping().variant()).equals(as.variant());
    }

    /** All, the best first, of each set of causes the best alone. */
    public List<Judged> eachSetOnce() {
        Set<Set<Cause>> taken = new HashSet<>();
        return judged.stream()
                .sorted(Comparator.comparingDouble(Judged::score))
                .filter(j -> taken.add(Set.copyOf(j.fit().hypothesis().causes())))
                .toList();
    }
}
