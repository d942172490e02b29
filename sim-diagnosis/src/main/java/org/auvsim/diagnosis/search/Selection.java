package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.residual.Outcome;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Selects the causes that explain what a model misses of measured runs: one or two at once, or
 * several common ones, others one by one, as few as are worth it.
 */
final class Selection {
    /** So many causes are tried for each run by itself. */
    private static final int OF_ONE_RUN = 4;

    /** So many of what was found in other steps. */
    private static final int AGAIN = 10;

    private static final double FALSE_ALARMS = 0.01;

    private final Fit base;
    private final Judged none;
    private final List<Cause> library;
    private final Optional<Arena.Contest> contest;
    private final boolean isThorough;
    private final Course course;
    private final Noise noise;
    private final Screening screening;
    private final Tried tried;
    private final Misreading misreading;
    private final OneOrTwo oneOrTwo;
    private final ForwardSelection forward;

    /**
     * Out of a library, in some way.
     *
     * @param base what follows the measurement by the model as it is believed
     * @param none that model, fitted
     */
    Selection(Fit base, Judged none, Noise noise, List<Cause> library, Way way, Course course) {
        this.base = base;
        this.none = none;
        this.noise = noise;
        this.library = library;
        this.contest = way.contest();
        this.isThorough = way.isThorough();
        this.course = course;
        this.screening = new Screening(base, noise, library, none.outcome(), course);
        Aliasing aliasing = new Aliasing(screening, noise, course);
        this.tried = new Tried(none, noise, course, aliasing::undone);
        this.misreading = new Misreading(base, none, noise, course);
        this.oneOrTwo =
                new OneOrTwo(
                        none,
                        library,
                        screening,
                        tried,
                        misreading,
                        !isThorough || isOneOdd(),
                        course);
        this.forward = new ForwardSelection(library, screening, tried, oneOrTwo, course);
    }

    /** Specific causes first; those that can imitate others only where none of those passes. */
    Search.Found found() {
        Judged best = contest.isPresent() ? contested(contest.get()) : oneOrTwo.best();
        boolean isOpen = contest.isEmpty() && !best.isWhite();
        List<Hypothesis> byRun =
                isOpen && !misreading.isLikelierThan(best) ? ofOneRun() : List.of();
        if (haveChanged(byRun) || (isOpen && misreading.isNearerThan(best))) {
            return asItIs(best, byRun);
        }
        if (isOpen && isThorough && !isOneOdd()) {
            best = forward.withMore(best, specific());
        }
        if (isOpen && isThorough && !best.isWhite() && course.goesOn()) {
            best = forward.rescued(best, specific());
        }
        best = contest.isEmpty() ? oneOrTwo.plainerThan(best) : best;
        return refined(isByChance(best) ? none : best);
    }

    /**
     * What was found in other steps, in these: of its sets, from where they fitted best there, the
     * best if that explains the runs here, too; or else all anew.
     */
    Search.Found foundAgain(Search.Found before) {
        if (!before.best().isWhite()) {
            return found();
        }
        List<Screen.Start> starts =
                before.judged().stream()
                        .filter(set -> !set.isNone())
                        .limit(AGAIN)
                        .map(Judged::fit)
                        .map(fit -> base.with(fit.hypothesis(), fit.windows()))
                        .map(fit -> new Screen.Start(fit, 1, 0))
                        .toList();
        Judged best = tried.pruned(tried.whole(tried.tournament(starts, none, 0.3, 0.7)));
        return best.isWhite() && !best.isNone() ? refined(best) : found();
    }

    /** With what is surely missed still, and what is chosen of that. */
    private Search.Found refined(Judged found) {
        Judged best = contest.isPresent() ? found : forward.completed(found);
        if (best.isWhite() && areSeveral(best) && contest.isEmpty() && course.goesOn()) {
            best = forward.rescued(best, specific());
        }
        return chosen(best.isNone() ? best : tried.settled(best));
    }

    private static boolean areSeveral(Judged best) {
        return best.size() >= ForwardSelection.SEVERAL;
    }

    private List<Cause> specific() {
        return library.stream().filter(c -> !c.isGeneric()).toList();
    }

    /**
     * What is believed of that and what the data cannot tell from it. If it is not what was found,
     * what the data cannot tell from that may not have been tried yet.
     */
    private Search.Found chosen(Judged found) {
        Traces traces = screening.traces(found);
        Judged best = exchanged(found, traces);
        Choice choice = choice(best);
        Judged chosen = choice.instead(best, course);
        if (!chosen.hasCausesOf(best) && !chosen.isNone()) {
            Judged fewest = tried.pruned(chosen);
            best = exchanged(fewest, screening.traces(fewest));
            choice = choice(best);
            chosen = choice.instead(best, course);
        }
        return new Search.Found(
                chosen.isNone() ? chosen : none,
                chosen,
                choice.judged(),
                choice.competitors(chosen),
                chosen.hasCausesOf(found) ? traces : screening.traces(chosen),
                noise,
                List.of(),
                misreading);
    }

    /** Of runs that no set is to explain: something changed between them, or was mixed up. */
    private Search.Found asItIs(Judged best, List<Hypothesis> byRun) {
        Choice choice = choice(best);
        return new Search.Found(
                none,
                best,
                choice.judged(),
                choice.competitors(best),
                screening.traces(best),
                noise,
                byRun,
                misreading);
    }

    /**
     * Whether the model as it is misses one run of several alone: one cause may act in that alone,
     * but no sum of them is to explain it.
     */
    private boolean isOneOdd() {
        return OddRun.notice(none).isPresent();
    }

    /**
     * Whether one cause explains each run, but of other numbers: more causes would imitate that.
     */
    private boolean haveChanged(List<Hypothesis> byRun) {
        return new RunByRun(base.stepping(), none.fit().data(), noise, course)
                .notice(byRun)
                .isPresent();
    }

    /** What promises most to explain the run that the model misses most; nothing of only one. */
    private List<Hypothesis> ofOneRun() {
        int runs = none.fit().data().size();
        if (runs == 1 || !course.goesOn()) {
            return List.of();
        }
        int worst =
                IntStream.range(0, runs)
                        .boxed()
                        .max(Comparator.comparingDouble(this::missed))
                        .orElseThrow();
        return screening.ofRun(worst, library).stream().limit(OF_ONE_RUN).toList();
    }

    private double missed(int run) {
        return Outcome.squares(none.outcome().misses().get(run));
    }

    private Choice choice(Judged best) {
        tried.underSpecificNames(best, library);
        return Choice.near(best, tried.eachSetOnce(), library);
    }

    /**
     * Where several miss something, others in their place will, too. What was exchanged may have
     * stood for what another of its causes stands for: each is exchanged again beside it.
     */
    private Judged exchanged(Judged found, Traces traces) {
        boolean isWorthIt =
                contest.isEmpty() && (found.isWhite() || (isThorough && !areSeveral(found)));
        if (!isWorthIt) {
            return found;
        }
        Judged best = new Exchange(library, screening, tried, course).best(found, traces);
        return best.hasCausesOf(found) || best.size() < 2
                ? best
                : exchanged(best, screening.traces(best));
    }

    /** Whether noise alone would gain as much, among all causes together, too often. */
    private boolean isByChance(Judged best) {
        double gain = none.score() - best.score();
        return !best.isNone()
                && gain <= OneOrTwo.DOUBTFUL
                && course.goesOn()
                && gain < screening.of(library).chance().exceededBy(FALSE_ALARMS);
    }

    /** The best of models that compete, those that can imitate others only where none passes. */
    private Judged contested(Arena.Contest models) {
        List<Cause> specific = specific();
        Judged best = competing(models, specific);
        boolean areMore = specific.size() < library.size();
        return best.isWhite() || !areMore || !course.goesOn()
                ? best
                : Tried.best(List.of(competing(models, library)), best);
    }

    private Judged competing(Arena.Contest models, List<Cause> causes) {
        List<Screen.Start> starts =
                models.candidates(new Arena(base, course), causes).stream()
                        .map(c -> new Hypothesis(c.causes(), c.theta()))
                        .map(h -> new Screen.Start(base.with(h, base.windows()), 1, 0))
                        .toList();
        return tried.pruned(tried.tournament(starts, none, 0.4, 0.7));
    }
}
