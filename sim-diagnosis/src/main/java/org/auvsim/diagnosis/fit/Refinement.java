package org.auvsim.diagnosis.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;

/**
 * Brings the parameters of a hypothesis, and the starts of its runs, to where the model fits best:
 * first in blocks of windows, which cannot get lost, then in blocks twice as long, at last in one
 * go from the start of each run.
 */
final class Refinement {
    private static final int MORE_STEPS = 1;
    private static final int MOST_HALVINGS = 5;

    /** A step turns no window by more (rad): beyond that it is not linear. */
    private static final double MOST_TURN = 0.7;

    /** Steps that turn windows by less (rad) have arrived. */
    private static final double ARRIVED = 0.02;

    /** Steps that do not lead on, though they should, are damped by these (Marquardt 1963). */
    private static final double[] DAMPINGS = {1e-3, 1e-2, 0.1, 1};

    /** A share of the cost that is not worth a step. */
    private static final double ENOUGH = 1e-4;

    /** A step leads on that leaves less than this share of what is missed. */
    private static final double LEADING_ON = 0.25;

    /** All that follow one gain no more than so many like it; of fewer, long valleys are missed. */
    private static final int MOST_HOPED = 40;

    private Refinement() {}

    /** A step that is to be made. */
    private static final class Step {
        private final List<List<WindowBlock>> blocks;
        private final Gram gram;
        private final Bounds bounds;
        private final double[] change;
        private final double turn;

        Step(List<List<WindowBlock>> blocks, Gram gram, Bounds bounds, double[] change) {
            this.blocks = blocks;
            this.gram = gram;
            this.bounds = bounds;
            this.change = change;
            this.turn = largestTurn(blocks, change);
        }

        /** By how much (rad) the window that turns most does so. */
        double turn() {
            return turn;
        }

        /** The same, shorter along what is hardly determined. */
        Step damped(double damping) {
            double[] shorter = gram.solve(all(change.length), bounds, damping);
            return new Step(blocks, gram, bounds, shorter);
        }

        /** By how much it should make the cost smaller, starts and all. */
        double promise(double cost) {
            return cost - least();
        }

        /** What would be missed after it, the starts of all blocks free. */
        double least() {
            return gram.cost() - gram.drop(all(change.length), change);
        }

        /** Windows and parameters after a share of it, and of what keeps it linear. */
        Fit from(Fit fit, double share) {
            return moved(fit, blocks, change, share * linear(turn));
        }
    }

    /** Empty if the motion gets lost in a window, or what parameters do to it is out of bounds. */
    private static Optional<Step> step(Fit fit, int perBlock) {
        List<List<WindowDerivatives>> derivatives = fit.derivatives();
        for (List<WindowDerivatives> ofRun : derivatives) {
            for (WindowDerivatives window : ofRun) {
                if (window.isLost()) {
                    return Optional.empty();
                }
            }
        }
        List<List<WindowBlock>> blocks = fit.blocks(derivatives, perBlock);
        int size = fit.hypothesis().size();
        Gram gram =
                Gram.of(blocks, size)
                        .with(fit.knowledge(), fit.hypothesis().numbers())
                        .cautious(fit.hypothesis().parameters());
        if (!gram.isFinite()) {
            return Optional.empty();
        }
        Bounds bounds = fit.hypothesis().bounds();
        return Optional.of(new Step(blocks, gram, bounds, gram.solve(all(size), bounds)));
    }

    /**
     * What a fit would still miss, to first order, after the change of starts and parameters that
     * suits it best; empty if the motion gets lost.
     */
    static OptionalDouble least(Fit fit) {
        return step(fit, 1).map(Step::least).map(OptionalDouble::of).orElse(OptionalDouble.empty());
    }

    private static int[] all(int size) {
        return IntStream.range(0, size).toArray();
    }

    private static Fit moved(
            Fit fit, List<List<WindowBlock>> blocks, double[] change, double share) {
        double[] gone = new double[change.length];
        for (int i = 0; i < gone.length; i++) {
            gone[i] = share * change[i];
        }
        return fit.with(fit.hypothesis().plus(gone), windows(blocks, change, share));
    }

    /** By how much (rad) the window that turns most does so. */
    private static double largestTurn(List<List<WindowBlock>> blocks, double[] change) {
        double turn = 0;
        for (List<WindowBlock> ofRun : blocks) {
            for (WindowBlock block : ofRun) {
                turn = Math.max(turn, block.largestTurn(change));
            }
        }
        return turn;
    }

    /** The share of a step with such a turn that is linear. */
    private static double linear(double turn) {
        return Math.min(1, MOST_TURN / Math.max(turn, 1e-300));
    }

    /** Windows moved as a change of parameters asks for, as far as that is linear. */
    static List<List<Window>> windows(List<List<WindowBlock>> blocks, double[] change) {
        return windows(blocks, change, linear(largestTurn(blocks, change)));
    }

    /** Windows moved by a share of what a change of parameters asks for. */
    private static List<List<Window>> windows(
            List<List<WindowBlock>> blocks, double[] change, double share) {
        List<List<Window>> windows = new ArrayList<>();
        for (List<WindowBlock> ofRun : blocks) {
            List<Window> moved = new ArrayList<>();
            ofRun.forEach(block -> moved.addAll(block.moved(change, share)));
            windows.add(moved);
        }
        return windows;
    }

    /**
     * From blocks of so many windows up to whole runs, a few steps there, and the best in one go of
     * where that has led.
     */
    static Judged approach(Fit start, int perBlock) {
        return approach(start, perBlock, Double.POSITIVE_INFINITY, Course.UNHEARD).judged();
    }

    /**
     * How near a fit came.
     *
     * @param isGivenUp whether it will miss too much
     */
    record Near(Judged judged, boolean isGivenUp) {}

    /**
     * The same, which ends where it is once it was told to stop, or where what will be missed is
     * more than that, and hardly less than a step before.
     */
    static Near approach(Fit start, int perBlock, double hopeless, Course course) {
        Judged best = Judged.of(start.whole());
        Fit fit = start;
        double before = Double.POSITIVE_INFINITY;
        int longest = start.longest();
        int more = 0;
        for (int block = perBlock; more <= MORE_STEPS; block = Math.min(2 * block, longest)) {
            Optional<Step> step = course.goesOn() ? step(fit, block) : Optional.empty();
            if (step.isEmpty()) {
                break;
            }
            double least = step.get().least();
            if (least > hopeless && least > LEADING_ON * before) {
                return new Near(best, true);
            }
            before = least;
            fit = step.get().from(fit, 1);
            if (block < longest) {
                continue;
            }
            Judged whole = Judged.of(fit.whole());
            best = whole.cost() < best.cost() ? whole : best;
            if (!(step.get().turn() > ARRIVED) && more > 0) {
                break;
            }
            more++;
        }
        return new Near(best, false);
    }

    /** Gauss-Newton steps of whole runs, shortened until they help. */
    static Judged converge(Judged start, int mostSteps) {
        return converge(start, mostSteps, Double.POSITIVE_INFINITY, Course.UNHEARD);
    }

    /**
     * The same, given up where a score is out of reach, as far as the last step tells, and once it
     * was told to stop.
     */
    static Judged converge(Judged start, int mostSteps, double score, Course course) {
        Judged best = start;
        for (int s = 0; s < mostSteps && Double.isFinite(best.cost()) && course.goesOn(); s++) {
            Judged next = better(best);
            boolean isWorthIt = isWorthIt(best.cost() - next.cost(), next);
            double hoped = MOST_HOPED * (best.score() - next.score());
            boolean isNear = next.score() - hoped < score;
            best = next;
            if (!isWorthIt || !isNear) {
                break;
            }
        }
        return best;
    }

    private static boolean isWorthIt(double gain, Judged of) {
        return gain > ENOUGH * of.cost();
    }

    private static Judged better(Judged from) {
        Optional<Step> step = step(from.fit(), 1);
        if (step.isEmpty()) {
            return from;
        }
        Judged next = shortened(from, step.get());
        boolean shouldGoOn = isWorthIt(step.get().promise(from.cost()), from);
        return shouldGoOn && !isWorthIt(from.cost() - next.cost(), next)
                ? damped(from, step.get(), next)
                : next;
    }

    private static Judged shortened(Judged from, Step step) {
        double share = 1;
        for (int h = 0; h < MOST_HALVINGS; h++) {
            Judged tried = Judged.of(step.from(from.fit(), share));
            if (tried.cost() < from.cost()) {
                return tried;
            }
            share /= 3;
        }
        return from;
    }

    private static Judged damped(Judged from, Step step, Judged otherwise) {
        Judged best = otherwise;
        for (double damping : DAMPINGS) {
            Judged tried = Judged.of(step.damped(damping).from(from.fit(), 1));
            best = tried.cost() < best.cost() ? tried : best;
        }
        return best;
    }
}
