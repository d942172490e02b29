package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.residual.Outcome;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.IntStream;

/**
 * Selects the causes that explain what a model misses of measured runs: one or two at once, or
 * several common ones, others one by one, as few as are worth it.
 */
final class Selection {
    private static final int MOST_CAUSES = 5;

    /** So many can imitate one with a place, a moment or a frequency. */
    static final int SEVERAL = 3;

    /** Of each level, so many causes are tried beside others. */
    private static final int FORWARD = 2;

    /** So many causes are tried for each run by itself. */
    private static final int OF_ONE_RUN = 4;

    /** So many of what was found in other steps. */
    private static final int AGAIN = 10;

    /** A gain below this may be one of noise, among so many causes. */
    static final double DOUBTFUL = 30;

    /** What promises more beside what leaves noise alone is tried. */
    private static final double TELLING = 5;

    /** Squares of what is missed (standard deviations) a number, where little is missed. */
    private static final double NEARLY = 5;

    private static final double FALSE_ALARMS = 0.01;

    /** What promises less than this share of a gain, to first order, does not gain more. */
    private static final double PROMISING = 0.5;

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

    /** Where causes that can imitate others are begun alone. */
    private final Once<List<Screen.Start>> generic;

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
        this.misreading = new Misreading(none, noise, course);
        this.generic = new Once<>(this::genericStarts);
    }

    /** Specific causes first; those that can imitate others only where none of those passes. */
    Search.Found found() {
        List<Cause> specific = specific();
        Judged best = contest.isPresent() ? contested(contest.get(), specific) : oneOrTwo(specific);
        boolean isOpen = contest.isEmpty() && !best.isWhite();
        List<Hypothesis> byRun = isOpen && !areMisread(best) ? ofOneRun() : List.of();
        if (haveChanged(byRun) || (isOpen && misreading.isNearerThan(best))) {
            return asItIs(best, byRun);
        }
        if (isOpen && isThorough && !isOneOdd()) {
            best = withMore(best, specific);
        }
        if (isOpen && isThorough && !best.isWhite() && course.goesOn()) {
            best = rescued(best, specific);
        }
        best = contest.isEmpty() ? plainer(best) : best;
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
        Judged best = found;
        for (Judged more = completed(best); !more.equals(best); more = completed(best)) {
            best = more;
        }
        if (best.isWhite() && areSeveral(best) && contest.isEmpty() && course.goesOn()) {
            best = rescued(best, specific());
        }
        return chosen(best.isNone() ? best : tried.settled(best));
    }

    private List<Screen.Start> genericStarts() {
        List<Cause> causes = library.stream().filter(Cause::isGeneric).toList();
        return causes.isEmpty() ? List.of() : screening.of(causes).starts(1, cause -> true);
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

    /**
     * Whether orientations are told in another way, or commands where much is missed with what was
     * found: no cause is to explain that.
     */
    private boolean areMisread(Judged found) {
        return contest.isEmpty()
                && course.goesOn()
                && (misreading.isOfOrientations()
                        || (!isNear(found) && misreading.isNearerThan(found)));
    }

    private static boolean isNear(Judged found) {
        return found.cost() < NEARLY * found.outcome().count();
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
        return best.hasCausesOf(found) || best.fit().hypothesis().causes().size() < 2
                ? best
                : exchanged(best, screening.traces(best));
    }

    /**
     * With what is surely missed still, though all that is left together passes for noise: the test
     * of one cause sees more than that of any memory.
     */
    private Judged completed(Judged best) {
        boolean isOpen = !best.isNone() && hasRoom(best) && best.isWhite() && course.goesOn();
        if (!isOpen || contest.isPresent()) {
            return best;
        }
        List<Screen.Start> beside = more(best);
        List<Screen.Start> missed =
                beside.stream().filter(start -> start.promise() > TELLING).toList();
        Judged more =
                missed.isEmpty() ? best : tried.pruned(tried.tournament(missed, best, 0.8, 0.85));
        boolean mayStandForTwo =
                best.fit().hypothesis().causes().size() == 1
                        && beside.stream().anyMatch(start -> start.promise() > 0);
        return more.equals(best) && mayStandForTwo ? asTwo(best) : more;
    }

    /** Two other causes in place of one, where they promise more than any alone does. */
    private Judged asTwo(Judged one) {
        Hypothesis of = one.fit().hypothesis();
        Screen screen =
                screening.of(
                        library.stream()
                                .filter(c -> of.isGeneric() || !c.isGeneric())
                                .filter(c -> !c.isAmong(of.causes()))
                                .toList());
        List<Screen.Start> alone = screen.starts(1, cause -> true);
        List<Screen.Start> two =
                screen.starts(2, cause -> true).stream()
                        .filter(pair -> promisesMore(pair, alone))
                        .toList();
        return tried.pruned(tried.whole(tried.tournament(two, one, 0.8, 0.85)));
    }

    /** Than any cause alone does at that level, more than noise lets it. */
    private static boolean promisesMore(Screen.Start pair, List<Screen.Start> alone) {
        return alone.stream()
                .filter(other -> other.perBlock() == pair.perBlock())
                .allMatch(other -> pair.promise() > other.promise() + DOUBTFUL);
    }

    private static boolean areSeveral(Judged best) {
        return count(best) >= SEVERAL;
    }

    private static boolean hasRoom(Judged best) {
        return count(best) < MOST_CAUSES;
    }

    private static int count(Judged of) {
        return of.fit().hypothesis().causes().size();
    }

    /** With one more cause each, the most promising ones. */
    private List<Screen.Start> more(Judged best) {
        Hypothesis of = best.fit().hypothesis();
        List<Cause> others = library.stream().filter(c -> !c.isAmong(of.causes())).toList();
        return Screening.promisingOfEachLevel(screening.beside(of, others), FORWARD);
    }

    /** Whether noise alone would gain as much, among all causes together, too often. */
    private boolean isByChance(Judged best) {
        double gain = none.score() - best.score();
        return !best.isNone()
                && gain <= DOUBTFUL
                && course.goesOn()
                && gain < screening.of(library).chance().exceededBy(FALSE_ALARMS);
    }

    /** The best of models that compete, those that can imitate others only where none passes. */
    private Judged contested(Arena.Contest models, List<Cause> specific) {
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

    /**
     * The best set of one or two specific causes, or with one that can imitate others where none of
     * those passes. Where one of these alone promises more than any of those it is tried before two
     * of those are: if it leaves nothing but noise, most of the many pairs are given up early.
     */
    private Judged oneOrTwo(List<Cause> specific) {
        if (!course.at("screening causes", 0.2)) {
            return none;
        }
        Screen screen = screening.of(specific);
        List<Screen.Start> singles = screen.starts(1, cause -> true);
        Judged single = alone(singles, specific, cause -> true);
        if (single.isWhite() || !course.goesOn()) {
            return single;
        }
        Optional<Judged> early =
                promisesMore(generic.get(), singles)
                        ? Optional.of(genericAlone())
                        : Optional.empty();
        Judged best =
                early.filter(Judged::isWhite)
                        .map(white -> Tried.best(List.of(white), single))
                        .orElse(single);
        if (!best.isWhite() && isDone(best)) {
            return best;
        }
        best = withPairs(best, screen, specific, cause -> true);
        if (isDone(best) || specific.size() == library.size()) {
            return best;
        }
        Judged other = early.orElseGet(this::genericAlone);
        boolean areDoubtful = !isThorough || isOneOdd();
        if (!areDoubtful && !isDone(other)) {
            other = withPairs(other, screening.of(library), library, Cause::isGeneric);
        }
        return Tried.best(List.of(other), best);
    }

    private boolean isDone(Judged best) {
        return best.isWhite() || !course.goesOn() || areMisread(best);
    }

    /** Whether one of some promises more than any of others does at its level. */
    private static boolean promisesMore(List<Screen.Start> some, List<Screen.Start> others) {
        return some.stream().anyMatch(one -> promisesMore(one, others));
    }

    private Judged genericAlone() {
        return alone(generic.get(), library, Cause::isGeneric);
    }

    /** The best pair, if it is better than one cause alone. */
    private Judged withPairs(
            Judged single, Screen screen, List<Cause> causes, Predicate<Cause> isNew) {
        List<Screen.Start> pairs = new ArrayList<>(screen.starts(2, isNew));
        if (count(single) == 1 && !single.isWhite()) {
            pairs.addAll(screening.along(single, causes).starts(1, isNew));
        }
        return tried.pruned(tried.whole(tried.tournament(pairs, single, 0.5, 0.6)));
    }

    /** The best single cause. */
    private Judged alone(List<Screen.Start> starts, List<Cause> causes, Predicate<Cause> isNew) {
        Judged best = tried.whole(tried.tournament(starts, none, 0.3, 0.5));
        if (best.isWhite() || !course.goesOn()) {
            return best;
        }
        List<Screen.Start> along = screening.along(none, causes).starts(1, isNew);
        return tried.whole(tried.tournament(along, best, 0.4, 0.5));
    }

    /**
     * The best set of more causes, all of them common ones: of those that begin at many places,
     * moments or frequencies a few together imitate most of what there is.
     */
    private Judged several(List<Cause> causes, Judged found) {
        if (found.isWhite() || !course.goesOn()) {
            return found;
        }
        Screen screen =
                screening.of(causes.stream().filter(c -> !screening.hasManyGuesses(c)).toList());
        Judged best = found;
        for (int size = SEVERAL; size <= MOST_CAUSES && !best.isWhite(); size++) {
            Judged more = tried.tournament(screen.starts(size, cause -> true), best, 0.75, 0.8);
            best = more.equals(best) ? best : tried.pruned(tried.whole(more));
        }
        return best;
    }

    /**
     * With more causes, where something is missed: a few one by one, or else several common ones at
     * once, or else more beside those few.
     */
    private Judged withMore(Judged found, List<Cause> specific) {
        Judged few = extended(found, SEVERAL);
        Judged several = several(specific, few);
        if (several.isWhite()) {
            return several;
        }
        Judged more = extended(few, MOST_CAUSES);
        return more.score() < several.score() ? more : several;
    }

    /** With more causes, one by one, so many at most, while something is missed. */
    private Judged extended(Judged found, int most) {
        Judged best = found;
        while (count(best) < most && !best.isWhite() && course.goesOn()) {
            Judged more = tried.pruned(tried.freed(tried.tournament(more(best), best, 0.7, 0.75)));
            if (more.score() >= best.score()) {
                break;
            }
            best = more;
        }
        return best;
    }

    /**
     * One cause that can imitate others, where it says as much as several specific ones do, or may
     * say more than a single one or none. Where something is missed they were tried before.
     */
    private Judged plainer(Judged best) {
        Hypothesis of = best.fit().hypothesis();
        boolean wereTried = of.isGeneric() || !best.isWhite();
        if (wereTried || !course.goesOn()) {
            return best;
        }
        double enough = of.causes().size() < 2 ? PROMISING * (none.score() - best.score()) : 0;
        List<Screen.Start> starts =
                generic.get().stream().filter(start -> start.promise() >= enough).toList();
        return starts.isEmpty() ? best : tried.tournament(starts, best, 0.8, 0.85);
    }

    /**
     * Each cause alone is begun in blocks of every length: what promised less than others, or got
     * lost from long ones, may be it, as impacts tell little to first order. Then what has many
     * places to begin, at the best of them, and what takes another form, of which a small part
     * tells little, beside another.
     */
    private Judged rescued(Judged best, List<Cause> causes) {
        Judged alone = rescued(best, screening.of(causes));
        if (alone.isWhite()) {
            return alone;
        }
        List<Cause> many =
                causes.stream()
                        .filter(c -> screening.hasManyGuesses(c) || c.freer().isPresent())
                        .toList();
        return rescued(alone, screening.beside(tried.strongest(), many));
    }

    private Judged rescued(Judged best, Screen screen) {
        return tried.pruned(tried.whole(tried.tournament(screen.startsOfEach(), best, 0.8, 0.9)));
    }
}
