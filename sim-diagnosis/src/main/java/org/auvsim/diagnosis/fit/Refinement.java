package org.auvsim.diagnosis.fit;

import java.util.Optional;

/**
 * Brings the parameters of a hypothesis, and the starts of its runs, to where the model fits best:
 * first in blocks of windows, which cannot get lost, then in blocks twice as long, at last in one
 * go from the start of each run.
 */
public final class Refinement {
    private static final int MORE_STEPS = 1;

    /** Steps that turn windows by less (rad) have arrived. */
    private static final double ARRIVED = 0.02;

    /** A step leads on that leaves less than this share of what is missed. */
    private static final double LEADING_ON = 0.25;

    private Refinement() {}

    /**
     * From blocks of so many windows up to whole runs, a few steps there, and the best in one go of
     * where that has led.
     */
    public static Judged approach(Fit start, int perBlock) {
        return approach(start, perBlock, Double.POSITIVE_INFINITY, Course.UNHEARD).judged();
    }

    /**
     * How near a fit came.
     *
     * @param isGivenUp whether it will miss too much
     */
    public record Near(Judged judged, boolean isGivenUp) {}

    /**
     * The same, which ends where it is once it was told to stop, or where what will be missed is
     * more than that, and hardly less than a step before.
     */
    public static Near approach(Fit start, int perBlock, double hopeless, Course course) {
        Simulated at = Simulated.of(start.asSeen());
        int longest = start.longest();
        Judged best = whole(at);
        Tangents tangents = Tangents.of(at);
        double before = Double.POSITIVE_INFINITY;
        int more = 0;
        for (int block = perBlock; more <= MORE_STEPS; block = Math.min(2 * block, longest)) {
            if (!course.goesOn()) {
                break;
            }
            tangents = tangents.at(at);
            Optional<Step> step = Step.of(at.fit(), tangents, block);
            if (step.isEmpty()) {
                break;
            }
            double least = step.get().least();
            if (least > hopeless && least > LEADING_ON * before) {
                return new Near(best, true);
            }
            before = least;
            at = Simulated.of(step.get().end());
            if (block == longest) {
                Judged whole = whole(at);
                best = whole.cost() < best.cost() ? whole : best;
                if (!(step.get().turn() > ARRIVED) && more > 0) {
                    break;
                }
                more++;
            }
        }
        return new Near(best, false);
    }

    /** What a fit misses in its windows by themselves, each from where it fits best. */
    public static double leastOfWindows(Fit fit) {
        Simulated at = Simulated.of(fit.asSeen());
        return Step.of(at.fit(), Tangents.of(at), 1)
                .map(Step::least)
                .orElse(Double.POSITIVE_INFINITY);
    }

    /** What it misses of runs in one go from the start of each. */
    private static Judged whole(Simulated at) {
        return at.fit().longest() == 1 ? at.judged() : Judged.of(at.fit().whole());
    }
}
