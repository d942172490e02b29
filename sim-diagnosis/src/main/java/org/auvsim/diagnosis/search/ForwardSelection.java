package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;

import java.util.List;

/** Adds causes to those that were found, as few as are worth it, while something is missed. */
final class ForwardSelection {
    private static final int MOST_CAUSES = 5;

    /** So many can imitate one with a place, a moment or a frequency. */
    static final int SEVERAL = 3;

    /** Of each level, so many causes are tried beside others. */
    private static final int OF_EACH_LEVEL = 2;

    /** What promises more beside what leaves noise alone is tried. */
    private static final double TELLING = 5;

    private final List<Cause> library;
    private final Screening screening;
    private final Tried tried;
    private final OneOrTwo oneOrTwo;
    private final Course course;

    /** Out of a library. */
    ForwardSelection(
            List<Cause> library,
            Screening screening,
            Tried tried,
            OneOrTwo oneOrTwo,
            Course course) {
        this.library = library;
        this.screening = screening;
        this.tried = tried;
        this.oneOrTwo = oneOrTwo;
        this.course = course;
    }

    /**
     * With more causes, where something is missed: a few one by one, or else several common ones at
     * once, or else more beside those few.
     */
    Judged withMore(Judged found, List<Cause> specific) {
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
        while (best.size() < most && !best.isWhite() && course.goesOn()) {
            Judged more = tried.pruned(tried.freed(tried.tournament(more(best), best, 0.7, 0.75)));
            if (more.score() >= best.score()) {
                break;
            }
            best = more;
        }
        return best;
    }

    /** With one more cause each, the most promising ones. */
    private List<Screen.Start> more(Judged best) {
        Hypothesis of = best.fit().hypothesis();
        List<Cause> others = library.stream().filter(c -> !c.isAmong(of.causes())).toList();
        return Screening.promisingOfEachLevel(screening.beside(of, others), OF_EACH_LEVEL);
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
     * With what is surely missed still, though all that is left together passes for noise: the test
     * of one cause sees more than that of any memory.
     */
    Judged completed(Judged found) {
        Judged best = found;
        for (Judged more = withMissed(best); !more.equals(best); more = withMissed(best)) {
            best = more;
        }
        return best;
    }

    private Judged withMissed(Judged best) {
        boolean hasRoom = !best.isNone() && best.size() < MOST_CAUSES;
        if (!hasRoom || !best.isWhite() || !course.goesOn()) {
            return best;
        }
        List<Screen.Start> beside = more(best);
        List<Screen.Start> missed =
                beside.stream().filter(start -> start.promise() > TELLING).toList();
        Judged more =
                missed.isEmpty() ? best : tried.pruned(tried.tournament(missed, best, 0.8, 0.85));
        boolean mayStandForTwo =
                best.size() == 1 && beside.stream().anyMatch(start -> start.promise() > 0);
        return more.equals(best) && mayStandForTwo ? oneOrTwo.twoInPlaceOf(best) : more;
    }

    /**
     * Each cause alone is begun in blocks of every length: what promised less than others, or got
     * lost from long ones, may be it, as impacts tell little to first order. Then what has many
     * places to begin, at the best of them, and what takes another form, of which a small part
     * tells little, beside another.
     */
    Judged rescued(Judged best, List<Cause> causes) {
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
