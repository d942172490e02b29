package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Descent;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Refinement;
import org.auvsim.diagnosis.fit.Refinement.Near;
import org.auvsim.diagnosis.residual.Noise;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;

/**
 * All sets of causes come near to where they fit best, the best of them nearer, the best of those
 * to the end. What a set misses in blocks of windows, all starts free, is less than what it will
 * miss of whole runs. So once one set leaves nothing but noise, others are given up that miss far
 * more even so, and whose steps hardly lead on (branch and bound: Land &amp; Doig 1960); and once
 * several causes were found, those that miss more even so than these do of whole runs.
 */
public final class Tournament {
    private static final int SECOND_ROUND = 10;
    private static final int SECOND_STEPS = 3;
    private static final int THIRD_ROUND = 4;

    /** Enough steps for a set to come to where it fits best. */
    public static final int TO_THE_END = 40;

    /** Scores that are worse than the best by more are of no interest. */
    static final double BESIDE = 30;

    /** What misses more than noise does by this factor has no hope: steps are not quite linear. */
    private static final double HOPELESS = 3;

    /** The same of few numbers. */
    private static final double HOPELESS_OF_FEW = 100;

    /** Windows of a block that is short, though not as short as it may be. */
    private static final int SHORT = 2;

    private final Judged otherwise;
    private final Noise noise;
    private final Course course;
    private final double from;
    private final double to;
    private final AtomicInteger done = new AtomicInteger();

    /**
     * A tournament.
     *
     * @param otherwise what is to be beaten
     * @param from share of the whole search when it begins
     * @param to when it ends
     */
    Tournament(Judged otherwise, Noise noise, Course course, double from, double to) {
        this.otherwise = otherwise;
        this.noise = noise;
        this.course = course;
        this.from = from;
        this.to = to;
    }

    /** Those of the last round. */
    List<Judged> last(List<Screen.Start> starts) {
        double hopeless = hopeless(otherwise);
        List<Screen.Start> first = otherwise.isWhite() ? List.of() : favourites(starts);
        List<Near> near =
                new ArrayList<>(
                        near(first, starts.size(), hopeless).stream()
                                .map(this::foundAgain)
                                .toList());
        for (Near favourite : near) {
            hopeless = Math.min(hopeless, hopeless(favourite.judged()));
        }
        List<Screen.Start> others = starts.stream().filter(s -> !first.contains(s)).toList();
        near.addAll(near(others, starts.size(), hopeless));
        List<Near> nearer = best(near, SECOND_ROUND, SECOND_STEPS);
        return best(nearer, THIRD_ROUND, TO_THE_END).stream().map(Near::judged).toList();
    }

    /** What promises most at each level, each set of causes once, where it has least to go. */
    private static List<Screen.Start> favourites(List<Screen.Start> starts) {
        Map<Integer, Screen.Start> ofLevels = new LinkedHashMap<>();
        Comparator<Screen.Start> promise = Comparator.comparingDouble(Screen.Start::promise);
        for (Screen.Start start : starts) {
            ofLevels.merge(start.perBlock(), start, (a, b) -> promise.compare(a, b) < 0 ? b : a);
        }
        Map<List<Cause>, Screen.Start> ofSets = new LinkedHashMap<>();
        for (Screen.Start start : ofLevels.values()) {
            ofSets.merge(start.causes(), start, (a, b) -> a.perBlock() < b.perBlock() ? b : a);
        }
        return List.copyOf(ofSets.values());
    }

    private List<Near> near(List<Screen.Start> starts, int ofAll, double hopeless) {
        return starts.parallelStream()
                .filter(_ -> course.at("fitting sets of causes", share(ofAll)))
                .map(s -> Refinement.approach(s.fit(), s.perBlock(), hopeless, course))
                .toList();
    }

    /**
     * What got lost on its way begins anew in windows that follow the runs under it: those that
     * follow them by the model as it is believed hide what it lacks in their starts.
     */
    private Near foundAgain(Near favourite) {
        if (favourite.judged().score() < otherwise.score() || !course.goesOn()) {
            return favourite;
        }
        Fit lost = favourite.judged().fit();
        Fit anew = Following.of(lost.stepping(), lost.hypothesis(), lost.data(), noise, course);
        return Stream.of(1, Math.min(SHORT, anew.longest()))
                .distinct()
                .map(perBlock -> near(anew, perBlock))
                .filter(near -> near.score() < favourite.judged().score())
                .min(Comparator.comparingDouble(Judged::score))
                .map(near -> new Near(near, false))
                .orElse(favourite);
    }

    private Judged near(Fit start, int perBlock) {
        Near near = Refinement.approach(start, perBlock, Double.POSITIVE_INFINITY, course);
        return Descent.of(near.judged()).steps(SECOND_STEPS, Double.POSITIVE_INFINITY, course);
    }

    private double share(int ofAll) {
        return from + (to - from) * done.getAndIncrement() / ofAll;
    }

    /**
     * The cost that is too large to become like that of one which leaves nothing but noise, or less
     * than that of several causes.
     */
    private static double hopeless(Judged judged) {
        if (judged.isWhite()) {
            return HOPELESS * judged.cost() + HOPELESS_OF_FEW;
        }
        boolean areSeveral = judged.size() >= ForwardSelection.SEVERAL;
        return areSeveral ? judged.cost() + HOPELESS_OF_FEW : Double.POSITIVE_INFINITY;
    }

    private List<Near> best(List<Near> of, int most, int steps) {
        Set<List<Cause>> taken = new HashSet<>();
        double toBeat = toBeat(of);
        return of.stream()
                .sorted(Comparator.comparingDouble(near -> near.judged().score()))
                .filter(near -> taken.add(near.judged().fit().hypothesis().causes()))
                .limit(most)
                .toList()
                .parallelStream()
                .map(near -> near.isGivenUp() ? near : nearer(near.judged(), steps, toBeat))
                .toList();
    }

    private Near nearer(Judged judged, int steps, double toBeat) {
        return new Near(Descent.of(judged).steps(steps, toBeat, course), false);
    }

    /** The best score there is, and what may be of interest beside it. */
    private double toBeat(List<Near> round) {
        return BESIDE
                + Stream.concat(Stream.of(otherwise), round.stream().map(Near::judged))
                        .mapToDouble(Judged::score)
                        .min()
                        .orElseThrow();
    }
}
