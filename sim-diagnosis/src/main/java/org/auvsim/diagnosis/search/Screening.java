package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Guess;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.residual.Outcome;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/** Screens causes along the measured motion, as closely as a model can follow it. */
final class Screening {
    private final Fit base;
    private final Noise noise;
    private final List<Seed.Guesses> guesses;
    private final Outcome asBelieved;
    private final Course course;

    /** What followed the measurement last. */
    private Fit followed;

    /**
     * A screening of a library.
     *
     * @param base what follows the measurement by the model as it is believed
     * @param asBelieved what that model misses
     */
    Screening(Fit base, Noise noise, List<Cause> library, Outcome asBelieved, Course course) {
        List<MeasuredRun> runs = base.data().stream().map(Misses::run).toList();
        this.base = base;
        this.noise = noise;
        this.guesses = library.stream().map(c -> new Seed.Guesses(c, c.guesses(runs))).toList();
        this.asBelieved = asBelieved;
        this.course = course;
        this.followed = base;
    }

    /** Of the model as it is believed. */
    Screen of(List<Cause> causes) {
        return new Screen(base, causes, guesses, asBelieved);
    }

    /**
     * Common causes, one more each, around where something fits whole runs best: what is far off
     * for sure, as a heading by half a radian, is hidden in the starts of windows that follow the
     * measurement, and shows where the model goes another way.
     */
    Screen along(Judged fitted, List<Cause> causes) {
        List<Cause> of = fitted.fit().hypothesis().causes();
        List<Cause> others =
                causes.stream().filter(c -> !c.isAmong(of) && !hasManyGuesses(c)).toList();
        return new Screen(fitted.fit(), others, guesses, asBelieved);
    }

    /** Common causes that promise to explain one of the runs alone, the most promising first. */
    List<Hypothesis> ofRun(int run, List<Cause> library) {
        Fit alone = base.ofRun(run);
        List<Cause> common =
                library.stream().filter(c -> !c.isGeneric() && !hasManyGuesses(c)).toList();
        Screen screen = new Screen(alone, common, guesses, Judged.of(alone.whole()).outcome());
        Set<List<Cause>> sets = new HashSet<>();
        return promising(screen).stream()
                .filter(start -> sets.add(start.causes()))
                .map(start -> start.fit().hypothesis())
                .toList();
    }

    /** Beside those of a hypothesis. */
    Screen beside(Hypothesis hypothesis, List<Cause> causes) {
        return new Screen(following(hypothesis), causes, guesses, asBelieved);
    }

    /** Of one cause beside others, begun as these guesses have it. */
    Screen beside(Hypothesis others, Cause cause, List<Guess> from) {
        List<Seed.Guesses> begun = List.of(new Seed.Guesses(cause, from));
        return new Screen(following(others), List.of(cause), begun, asBelieved);
    }

    /** Along the motion of what was found, if that is sure: it tells how the body moved. */
    Screen beside(Hypothesis hypothesis, List<Cause> causes, Judged found) {
        if (!found.isWhite()) {
            return beside(hypothesis, causes);
        }
        Fit along = base.with(hypothesis, base.windows()).along(found.fit());
        return new Screen(along, causes, guesses, asBelieved);
    }

    /**
     * What each leaves beside something, but for those of many places, moments or frequencies;
     * nothing of any, once the search was told to stop.
     */
    Traces traces(Judged beside) {
        Hypothesis of = beside.fit().hypothesis();
        List<Cause> plain =
                guesses.stream().map(Seed.Guesses::cause).filter(c -> !hasManyGuesses(c)).toList();
        return course.goesOn() ? beside(of, plain).traces() : Traces.none(of);
    }

    /** Whether there are many places to begin. */
    boolean hasManyGuesses(Cause cause) {
        return guesses.stream().anyMatch(g -> g.cause().equals(cause) && g.guesses().size() > 2);
    }

    /** Whether it swings, at any of many frequencies. */
    boolean isSwept(Cause cause) {
        return guesses.stream().anyMatch(g -> g.cause().equals(cause) && g.isSwept());
    }

    /** With one cause each, the most promising first. */
    static List<Screen.Start> promising(Screen screen) {
        return screen.starts(1, cause -> true).stream()
                .sorted(Comparator.comparingDouble(Screen.Start::promise).reversed())
                .toList();
    }

    /**
     * The same, so many of each level in turn: what promises most over whole runs may only bend as
     * they do, where the motion is far from what the model has.
     */
    static List<Screen.Start> promisingOfEachLevel(Screen screen, int ofEach) {
        Map<Integer, List<Screen.Start>> ofLevels = new TreeMap<>();
        Set<List<Cause>> sets = new HashSet<>();
        for (Screen.Start start : promising(screen)) {
            List<Screen.Start> ofLevel =
                    ofLevels.computeIfAbsent(start.perBlock(), _ -> new ArrayList<>());
            if (ofLevel.size() < ofEach && sets.add(start.causes())) {
                ofLevel.add(start);
            }
        }
        return ofLevels.values().stream().flatMap(List::stream).toList();
    }

    /** Windows that follow the measurement under a hypothesis. */
    private Fit following(Hypothesis hypothesis) {
        if (!followed.hypothesis().equals(hypothesis)) {
            followed = Following.of(base.stepping(), hypothesis, base.data(), noise, course);
        }
        return followed;
    }
}
