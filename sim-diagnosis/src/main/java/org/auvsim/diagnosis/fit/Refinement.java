package org.auvsim.diagnosis.fit;

import org.auvsim.core.step.StepException;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Brings the parameters of a set of causes, and the starts of its runs, to where the model fits best:
 * first in blocks of windows, which cannot get lost, then in blocks twice as long, at last in one go
 * from the start of each run.
 */
final class Refinement {
    private static final int MOST_STEPS = 8;
    private static final int MOST_HALVINGS = 5;
    private static final double ENOUGH = 1e-4;

    private Refinement() {}

    /** One step with windows chained in blocks of so many. */
    static Fit step(Fit fit, int perBlock) {
        return moved(fit, fit.blocks(fit.derivatives(), perBlock), 1);
    }

    private static Fit moved(Fit fit, List<List<WindowBlock>> blocks, double share) {
        int size = fit.hypothesis().size();
        int[] all = IntStream.range(0, size).toArray();
        double[] change = size == 0 ? new double[0] : new Gram(blocks, size).solve(all);
        return moved(fit, blocks, change, fit.hypothesis(), share);
    }

    /** The windows moved as a change of parameters asks for, and these for the hypothesis given. */
    static Fit moved(
            Fit fit,
            List<List<WindowBlock>> blocks,
            double[] change,
            Hypothesis hypothesis,
            double share) {
        double[] gone = new double[change.length];
        for (int i = 0; i < gone.length; i++) {
            gone[i] = share * change[i];
        }
        List<List<Window>> windows = new ArrayList<>();
        for (List<WindowBlock> ofRun : blocks) {
            List<Window> moved = new ArrayList<>();
            ofRun.forEach(block -> moved.addAll(block.moved(change, share)));
            windows.add(moved);
        }
        return fit.with(hypothesis.plus(gone), windows);
    }

    /** From blocks of so many windows up to whole runs, then until nothing is gained any more. */
    static Fit refine(Fit start, int perBlock) {
        Fit fit = start;
        int longest = start.longest();
        try {
            for (int block = perBlock; block < longest; block *= 2) {
                fit = step(fit, block);
            }
            fit = step(fit, longest);
        } catch (StepException e) {
            fit = start; // lost its way: what follows begins where the windows did
        }
        Fit whole = whole(fit);
        return converge(whole.cost() < whole(start).cost() ? whole : whole(start));
    }

    /** One window a run. */
    static Fit whole(Fit fit) {
        List<List<Window>> windows = new ArrayList<>();
        for (int r = 0; r < fit.data().size(); r++) {
            Window first = fit.windows().get(r).getFirst();
            windows.add(
                    List.of(new Window(0, fit.data().get(r).run().size() - 1, first.start())));
        }
        return fit.with(fit.hypothesis(), windows);
    }

    /** Gauss-Newton steps of whole runs, halved until they help. */
    static Fit converge(Fit start) {
        Fit best = start;
        double cost = start.cost();
        if (Double.isInfinite(cost)) {
            return best;
        }
        for (int s = 0; s < MOST_STEPS; s++) {
            List<List<WindowBlock>> blocks = best.blocks(best.derivatives(), 1);
            double before = cost;
            double share = 1;
            for (int h = 0; h < MOST_HALVINGS; h++) {
                Fit tried = moved(best, blocks, share);
                double triedCost = tried.cost();
                if (triedCost < cost) {
                    best = tried;
                    cost = triedCost;
                    break;
                }
                share /= 3;
            }
            if (!(before - cost > ENOUGH * cost)) {
                break;
            }
        }
        return best;
    }
}
