package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;

/**
 * The best set of one cause or two that explains what a model misses: specific causes first, those
 * that can imitate others (generic ones) only where none of those passes.
 */
final class OneOrTwo {
    /** A gain below this may be one of noise, among so many causes. */
    static final double DOUBTFUL = 30;

    /** What promises less than this share of a gain, to first order, does not gain more. */
    private static final double PROMISING = 0.5;

    private final Judged none;
    private final List<Cause> library;
    private final List<Cause> specific;
    private final Screening screening;
    private final Tried tried;
    private final Misreading misreading;
    private final boolean areDoubtful;
    private final Course course;

    /** Where causes that can imitate others are begun alone. */
    private final Once<List<Screen.Start>> generic;

    /**
     * Out of a library.
     *
     * @param none the model as it is believed, fitted
     * @param areDoubtful whether something is so odd about the runs that pairs with causes which
     *     can imitate others are not to explain them
     */
    OneOrTwo(
            Judged none,
            List<Cause> library,
            Screening screening,
            Tried tried,
            Misreading misreading,
            boolean areDoubtful,
            Course course) {
        this.none = none;
        this.library = library;
        this.specific = library.stream().filter(cause -> !cause.isGeneric()).toList();
        this.screening = screening;
        this.tried = tried;
        this.misreading = misreading;
        this.areDoubtful = areDoubtful;
        this.course = course;
        this.generic = new Once<>(this::genericStarts);
    }

    private List<Screen.Start> genericStarts() {
        List<Cause> causes = library.stream().filter(Cause::isGeneric).toList();
        return causes.isEmpty() ? List.of() : screening.of(causes).starts(1, cause -> true);
    }

    /**
     * The best set. Where a generic cause alone promises more than any specific one it is tried
     * before two of those are: if it leaves nothing but noise, most of the many pairs are given up
     * early.
     */
    Judged best() {
        if (!course.at("screening causes", 0.2) || misreading.isSurelyOfCommands()) {
            return none;
        }
        Screen screen = screening.of(specific);
        List<Screen.Start> singles = screen.starts(1, cause -> true);
        Judged single = alone(singles, specific, cause -> true);
        if (single.isWhite() || !course.goesOn()) {
            return single;
        }
        Optional<Judged> early =
                generic.get().stream().anyMatch(start -> promisesMore(start, singles))
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
        if (!areDoubtful && !isDone(other)) {
            other = withPairs(other, screening.of(library), library, Cause::isGeneric);
        }
        return Tried.best(List.of(other), best);
    }

    private boolean isDone(Judged best) {
        return best.isWhite() || !course.goesOn() || misreading.isLikelierThan(best);
    }

    private Judged genericAlone() {
        return alone(generic.get(), library, Cause::isGeneric);
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

    /** The best pair, if it is better than one cause alone. */
    private Judged withPairs(
            Judged single, Screen screen, List<Cause> causes, Predicate<Cause> isNew) {
        List<Screen.Start> pairs = new ArrayList<>(screen.starts(2, isNew));
        if (single.size() == 1 && !single.isWhite()) {
            pairs.addAll(screening.along(single, causes).starts(1, isNew));
        }
        return tried.pruned(tried.whole(tried.tournament(pairs, single, 0.5, 0.6)));
    }

    /** Two other causes in place of one, where they promise more than any alone does. */
    Judged twoInPlaceOf(Judged one) {
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

    /** Than any of others does at its level, more than noise lets it. */
    private static boolean promisesMore(Screen.Start one, List<Screen.Start> others) {
        return others.stream()
                .filter(other -> other.perBlock() == one.perBlock())
                .allMatch(other -> one.promise() > other.promise() + DOUBTFUL);
    }

    /**
     * One generic cause, where it says as much as several specific ones do, or may say more than a
     * single one or none. Where something is missed they were tried before.
     */
    Judged plainerThan(Judged best) {
        boolean wereTried = best.fit().hypothesis().isGeneric() || !best.isWhite();
        if (wereTried || !course.goesOn()) {
            return best;
        }
        double enough = best.size() < 2 ? PROMISING * (none.score() - best.score()) : 0;
        List<Screen.Start> starts =
                generic.get().stream().filter(start -> start.promise() >= enough).toList();
        return starts.isEmpty() ? best : tried.tournament(starts, best, 0.8, 0.85);
    }
}
