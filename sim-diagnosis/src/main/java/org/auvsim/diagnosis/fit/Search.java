package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Predicate;

/** Looks for the causes that explain what a model misses of measured runs. */
final class Search {
    private static final int MOST_CAUSES = 3;
    private static final int FORWARD = 4;

    /** A model that lacks nothing needs few; how badly another one fits need not be known well. */
    private static final int NONE_STEPS = 8;

    /** A gain below this may be one of noise, among so many causes. */
    private static final double DOUBTFUL = 30;

    private static final double FALSE_ALARMS = 0.01;

    private final BelievedModel model;
    private final List<MeasuredRun> runs;
    private final Stepping stepping;
    private final Noise noise;
    private final Fit base;
    private final List<Cause> library;
    private final List<Seed.Guesses> guesses;
    private final Course course;
    private final Optional<Arena.Contest> contest;
    private final List<Judged> judged = new ArrayList<>();

    /** What followed the measurement last. */
    private Fit followed;

    /** By columns of a screening, or else by a contest of models. */
    Search(
            BelievedModel model,
            List<MeasuredRun> runs,
            List<Cause> library,
            Optional<Arena.Contest> contest,
            Course course) {
        this(model, runs, library, contest, course, StepLength::converged);
    }

    private Search(
            BelievedModel model,
            List<MeasuredRun> runs,
            List<Cause> library,
            Optional<Arena.Contest> contest,
            Course course,
            Function<Fit, Stepping> length) {
        this.model = model;
        this.runs = runs;
        this.noise = Noise.of(runs);
        List<Misses> data = Misses.of(runs, noise);
        course.at("following the runs", 0.02);
        Stepping first = Stepping.longer(model).getFirst();
        Fit asStated = Following.of(first, Hypothesis.NONE, data, noise, course);
        this.stepping = course.goesOn() ? length.apply(asStated) : first;
        this.base =
                stepping.fine().equals(model)
                        ? asStated.in(stepping)
                        : Following.of(stepping, Hypothesis.NONE, data, noise, course);
        this.followed = base;
        this.library = library;
        this.guesses = library.stream().map(c -> new Seed.Guesses(c, c.guesses(runs))).toList();
        this.course = course;
        this.contest = contest;
    }

    /**
     * What was found.
     *
     * @param none the model as it is believed
     * @param best the best set of causes; that of none if no set is better
     * @param judged all sets, the best first
     * @param competitors sets that explain the runs about as well as the best
     * @param traces what causes leave in the data beside those of the best
     */
    record Found(
            Judged none,
            Judged best,
            List<Judged> judged,
            List<Judged> competitors,
            Traces traces,
            Noise noise) {
        /** The model, in steps that are short enough. */
        Stepping stepping() {
            return none.fit().stepping();
        }

        /** The same, if none of what was found is true. */
        Found nothing() {
            return new Found(none, none, judged, List.of(), traces, noise);
        }

        /** The best, one of its causes left out. */
        Judged without(int cause) {
            Hypothesis of = best.fit().hypothesis();
            if (of.causes().size() == 1) {
                return none;
            }
            Hypothesis fewer = of.without(cause);
            return judged.stream()
                    .filter(j -> j.fit().hypothesis().causes().equals(fewer.causes()))
                    .findFirst()
                    .orElseGet(() -> fitted(fewer));
        }

        private Judged fitted(Hypothesis hypothesis) {
            Fit fit = best.fit().with(hypothesis, best.fit().windows());
            return Refinement.converge(Judged.of(fit), Tournament.TO_THE_END);
        }
    }

    /** What is found, again in steps to each sample if what was would need them. */
    Found found() {
        Found found = inTheseSteps();
        return StepLength.doFor(found.best().fit()) || !course.goesOn()
                ? found
                : new Search(model, runs, library, contest, course, StepLength::atEachSample)
                        .inTheseSteps();
    }

    /** Specific causes first; those that can imitate others only where none of those passes. */
    private Found inTheseSteps() {
        course.at("fitting the model as it is", 0.1);
        Judged none =
                Refinement.converge(
                        Refinement.approach(base, 1), NONE_STEPS, Double.POSITIVE_INFINITY, course);
        judged.add(none);
        List<Cause> specific = library.stream().filter(c -> !c.isGeneric()).toList();
        Judged best = searched(none, specific, cause -> true);
        if (!isWhite(best) && specific.size() < library.size() && course.goesOn()) {
            Judged generic = searched(none, library, Cause::isGeneric);
            best = generic.score() < best.score() ? generic : best;
        }
        if (contest.isEmpty()) {
            best = extended(best);
        }
        if (!isWhite(best) && contest.isEmpty() && course.goesOn()) {
            best = rescued(best, specific);
        }
        best = contest.isEmpty() ? plainer(best) : best;
        best = isByChance(none, best) ? none : best;
        List<Cause> plain = library.stream().filter(c -> !hasManyGuesses(c)).toList();
        for (Judged more = completed(best); !more.equals(best); more = completed(best)) {
            best = more;
        }
        return chosen(none, best, plain);
    }

    /**
     * What is believed of that and what the data cannot tell from it. If it is not what was found,
     * what the data cannot tell from that may not have been tried yet.
     */
    private Found chosen(Judged none, Judged found, List<Cause> plain) {
        Traces traces = traces(found, plain);
        Judged best = exchanged(found, traces);
        Choice choice = Choice.near(best, eachSetOnce(), library);
        Judged chosen = choice.instead(best, course);
        if (!hasCausesOf(chosen, best) && !chosen.isNone()) {
            best = exchanged(chosen, traces(chosen, plain));
            choice = Choice.near(best, eachSetOnce(), library);
            chosen = choice.instead(best, course);
        }
        return new Found(
                none,
                chosen,
                choice.judged(),
                choice.competitors(chosen),
                hasCausesOf(chosen, found) ? traces : traces(chosen, plain),
                noise);
    }

    private static boolean hasCausesOf(Judged one, Judged other) {
        return isSame(one.fit().hypothesis().causes(), other.fit().hypothesis().causes());
    }

    /**
     * With what is surely missed still, though all that is left together passes for noise: the test
     * of one cause sees more than that of any memory.
     */
    private Judged completed(Judged best) {
        boolean isOpen = !best.isNone() && hasRoom(best) && isWhite(best) && course.goesOn();
        if (!isOpen || contest.isPresent()) {
            return best;
        }
        List<Screen.Start> missed =
                more(best).stream().filter(start -> start.promise() > DOUBTFUL).toList();
        return missed.isEmpty() ? best : pruned(tournament(missed, best, 0.8, 0.85));
    }

    /** What causes leave beside something; those of none, once the search was told to stop. */
    private Traces traces(Judged beside, List<Cause> causes) {
        Hypothesis of = beside.fit().hypothesis();
        return course.goesOn() ? screen(of, causes).traces() : Traces.none(of);
    }

    private static boolean hasRoom(Judged best) {
        return best.fit().hypothesis().causes().size() < MOST_CAUSES;
    }

    /** With one more cause each, the most promising ones. */
    private List<Screen.Start> more(Judged best) {
        Hypothesis of = best.fit().hypothesis();
        List<Cause> others = library.stream().filter(c -> !of.causes().contains(c)).toList();
        return promising(screen(of, others)).stream().limit(FORWARD).toList();
    }

    /** With one cause each, the most promising first. */
    private static List<Screen.Start> promising(Screen screen) {
        return screen.starts(1, cause -> true).stream()
                .sorted(Comparator.comparingDouble(Screen.Start::promise).reversed())
                .toList();
    }

    private Screen screen(Hypothesis beside, List<Cause> causes) {
        return new Screen(following(beside), causes, guesses, asBelieved());
    }

    /** Along the motion of what was found, if that is sure: it tells how the body moved. */
    private Screen screen(Hypothesis beside, List<Cause> causes, Judged found) {
        if (!isWhite(found)) {
            return screen(beside, causes);
        }
        Fit along = base.with(beside, base.windows()).along(found.fit());
        return new Screen(along, causes, guesses, asBelieved());
    }

    /** Of the model as it is believed. */
    private Outcome asBelieved() {
        return judged.getFirst().outcome();
    }

    /** Whether noise alone would gain as much, among all causes together, too often. */
    private boolean isByChance(Judged none, Judged best) {
        double gain = none.score() - best.score();
        if (best.isNone() || gain > DOUBTFUL || !course.goesOn()) {
            return false;
        }
        Screen screen = new Screen(base, library, guesses, none.outcome());
        return gain < screen.chance().exceededBy(FALSE_ALARMS);
    }

    /**
     * The best set of one or two causes.
     *
     * @param isNew those of which a set must have one
     */
    private Judged searched(Judged none, List<Cause> causes, Predicate<Cause> isNew) {
        if (contest.isPresent()) {
            return pruned(tournament(competing(contest.get(), causes), none, 0.4, 0.7));
        }
        if (!course.at("screening causes", 0.2)) {
            return none;
        }
        Screen screen = new Screen(base, causes, guesses, asBelieved());
        Judged best = tournament(screen.starts(1, isNew), none, 0.3, 0.5);
        if (!isWhite(best) && course.goesOn()) {
            best = pruned(tournament(screen.starts(2, isNew), best, 0.5, 0.7));
        }
        return best;
    }

    /** With more causes, one by one, while something is missed. */
    private Judged extended(Judged found) {
        Judged best = found;
        while (hasRoom(best) && !isWhite(best) && course.goesOn()) {
            Judged more = pruned(tournament(more(best), best, 0.7, 0.8));
            if (more.score() >= best.score()) {
                break;
            }
            best = more;
        }
        return best;
    }

    /** One cause that can imitate others, where it says as much as several specific ones do. */
    private Judged plainer(Judged best) {
        Hypothesis of = best.fit().hypothesis();
        List<Cause> generic = library.stream().filter(Cause::isGeneric).toList();
        if (of.causes().size() < 2 || of.isGeneric() || generic.isEmpty() || !course.goesOn()) {
            return best;
        }
        Screen screen = new Screen(base, generic, guesses, asBelieved());
        return tournament(screen.starts(1, cause -> true), best, 0.8, 0.85);
    }

    private List<Screen.Start> competing(Arena.Contest models, List<Cause> causes) {
        return models.candidates(new Arena(base, course), causes).stream()
                .map(c -> new Hypothesis(c.causes(), c.theta()))
                .map(h -> new Screen.Start(base.with(h, base.windows()), 1, 0))
                .toList();
    }

    /** What has many places to begin is begun at the best of them: alone, then beside another. */
    private Judged rescued(Judged best, List<Cause> causes) {
        List<Cause> many = causes.stream().filter(this::hasManyGuesses).toList();
        Judged alone = rescued(best, new Screen(base, many, guesses, asBelieved()));
        return isWhite(alone) ? alone : rescued(alone, screen(strongest(), many));
    }

    private Judged rescued(Judged best, Screen screen) {
        return pruned(tournament(screen.startsOfEach(), best, 0.8, 0.9));
    }

    /** The best cause alone. */
    private Hypothesis strongest() {
        return judged.stream()
                .filter(j -> j.fit().hypothesis().causes().size() == 1)
                .min(Comparator.comparingDouble(Judged::score))
                .map(j -> j.fit().hypothesis())
                .orElse(Hypothesis.NONE);
    }

    /**
     * The same with each of its causes exchanged for those that leave nearly the same trace: which
     * of two it is that the data cannot tell apart is not to depend on which was tried. Beside
     * others it is exchanged for the most promising ones, too: it may have been found before them,
     * and have stood for them. A specific cause stays before a generic one that fits about as well,
     * which is told beside it. Where as many as there may be miss something, others will, too.
     */
    private Judged exchanged(Judged found, Traces traces) {
        Judged best = found;
        Hypothesis of = found.fit().hypothesis();
        boolean isWorthIt = contest.isEmpty() && (hasRoom(found) || isWhite(found));
        for (int c = 0; c < of.causes().size() && isWorthIt && course.goesOn(); c++) {
            List<Screen.Start> starts = insteadOf(c, found, traces.alike(of.causes().get(c)));
            if (!starts.isEmpty()) {
                Judged other = tournament(starts, best, 0.8, 0.9);
                boolean isAsGood = of.isGeneric() || !other.fit().hypothesis().isGeneric();
                boolean isClear = best.score() - other.score() > DOUBTFUL;
                best = !other.equals(best) && (isAsGood || isClear) ? pruned(other) : best;
            }
        }
        return best;
    }

    /**
     * Sets that were not judged yet: others with an alias of a cause, or with what promises most.
     * Aliases are tried again whose fits ended far from it: they got lost.
     */
    private List<Screen.Start> insteadOf(int of, Judged found, List<Cause> aliases) {
        Hypothesis others = found.fit().hypothesis().without(of);
        List<Cause> lost =
                aliases.stream()
                        .filter(o -> !others.causes().contains(o))
                        .filter(o -> !isJudged(others, o, found.score() + Tournament.BESIDE))
                        .toList();
        List<Screen.Start> starts = new ArrayList<>(promising(others, lost, found));
        if (!others.causes().isEmpty()) {
            List<Cause> untried =
                    library.stream()
                            .filter(o -> !found.fit().hypothesis().causes().contains(o))
                            .filter(o -> !aliases.contains(o))
                            .filter(o -> !isJudged(others, o, Double.POSITIVE_INFINITY))
                            .toList();
            promising(others, untried, found).stream().limit(FORWARD).forEach(starts::add);
        }
        return starts;
    }

    private List<Screen.Start> promising(Hypothesis beside, List<Cause> causes, Judged found) {
        return causes.isEmpty() ? List.of() : promising(screen(beside, causes, found));
    }

    /** Whether a cause beside others was judged, and fitted as well as that. */
    private boolean isJudged(Hypothesis others, Cause cause, double score) {
        List<Cause> causes = others.and(cause, new double[0]).causes();
        return judged.stream()
                .filter(j -> j.score() < score)
                .anyMatch(j -> isSame(j.fit().hypothesis().causes(), causes));
    }

    private static boolean isSame(List<Cause> some, List<Cause> others) {
        return some.size() == others.size() && some.containsAll(others);
    }

    /** What was judged, the best first, of each set of causes the best alone. */
    private List<Judged> eachSetOnce() {
        Set<Set<Cause>> taken = new HashSet<>();
        return judged.stream()
                .sorted(Comparator.comparingDouble(Judged::score))
                .filter(j -> taken.add(Set.copyOf(j.fit().hypothesis().causes())))
                .toList();
    }

    private boolean hasManyGuesses(Cause cause) {
        return guesses.stream().anyMatch(g -> g.cause().equals(cause) && g.guesses().size() > 2);
    }

    /** Windows that follow the measurement under a hypothesis. */
    private Fit following(Hypothesis hypothesis) {
        if (!followed.hypothesis().equals(hypothesis)) {
            followed = Following.of(stepping, hypothesis, base.data(), noise, course);
        }
        return followed;
    }

    /** The best of all, if it is better than what was found otherwise. */
    private Judged tournament(List<Screen.Start> starts, Judged otherwise, double from, double to) {
        List<Judged> last = new Tournament(otherwise, course, from, to).last(starts);
        judged.addAll(last);
        return last.stream()
                .filter(j -> j.score() < otherwise.score())
                .min(Comparator.comparingDouble(Judged::score))
                .orElse(otherwise);
    }

    /** Without the causes that are not worth their price. */
    private Judged pruned(Judged start) {
        Judged best = start;
        boolean goesOn = true;
        while (goesOn && course.goesOn()) {
            goesOn = false;
            Hypothesis hypothesis = best.fit().hypothesis();
            for (int c = 0; hypothesis.causes().size() > 1 && c < hypothesis.causes().size(); c++) {
                Fit fewer = best.fit().with(hypothesis.without(c), best.fit().windows());
                double toBeat = best.score() + Tournament.BESIDE;
                Judged without =
                        Refinement.converge(
                                Judged.of(fewer), Tournament.TO_THE_END, toBeat, course);
                judged.add(without);
                if (without.score() < best.score()) {
                    best = without;
                    goesOn = true;
                    break;
                }
            }
        }
        return best;
    }

    /** Whether what is missed of each run is noise. */
    static boolean isWhite(Judged judged) {
        return whiteness(judged) < Whiteness.LIMIT;
    }

    /** The largest deviate of the block sums over all runs. */
    static double whiteness(Judged judged) {
        double largest = 0;
        for (int r = 0; r < judged.fit().data().size(); r++) {
            largest =
                    Math.max(
                            largest,
                            Whiteness.largest(
                                    judged.outcome().misses().get(r), judged.fit().data().get(r)));
        }
        return largest;
    }
}
