package org.auvsim.diagnosis.fit;

import org.auvsim.core.step.StepException;
import org.auvsim.diagnosis.fit.WindowDerivatives.Column;

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
    static Fit step(Fit fit, int perBlock, double share) {
        List<Column> columns = fit.columns();
        List<List<WindowBlock>> blocks =
                Fit.blocks(fit.runs(), fit.derivatives(columns), perBlock);
        return moved(fit, blocks, columns, share);
    }

    private static Fit moved(
            Fit fit, List<List<WindowBlock>> blocks, List<Column> columns, double share) {
        int[] all = IntStream.range(0, columns.size()).toArray();
        double[] change =
                all.length == 0 ? new double[0] : new Gram(blocks, columns.size()).solve(all);
        List<double[]> theta = new ArrayList<>();
        int at = 0;
        for (double[] before : fit.theta()) {
            double[] after = before.clone();
            for (int p = 0; p < after.length; p++) {
                after[p] += share * change[at++];
            }
            theta.add(after);
        }
        List<List<Window>> windows = new ArrayList<>();
        for (List<WindowBlock> ofRun : blocks) {
            List<Window> moved = new ArrayList<>();
            ofRun.forEach(block -> moved.addAll(block.moved(change, share)));
            windows.add(moved);
        }
        return new Fit(fit.model(), fit.runs(), fit.weights(), fit.causes(), theta, windows);
    }

    /** From blocks of so many windows up to whole runs, then until nothing is gained any more. */
    static Fit refine(Fit start, int perBlock) {
        Fit fit = start;
        int longest = start.windows().stream().mapToInt(List::size).max().orElse(1);
        try {
            for (int block = perBlock; block < longest; block *= 2) {
                fit = step(fit, block, 1);
            }
            fit = step(fit, longest, 1);
        } catch (StepException e) {
            fit = start; // lost its way: what follows begins where the windows did
        }
        Fit whole = whole(fit);
        return converge(whole.cost() < whole(start).cost() ? whole : whole(start));
    }

    /** One window a run. */
    static Fit whole(Fit fit) {
        List<List<Window>> windows = new ArrayList<>();
        for (int r = 0; r < fit.runs().size(); r++) {
            Window first = fit.windows().get(r).getFirst();
            windows.add(List.of(new Window(0, fit.runs().get(r).size() - 1, first.start())));
        }
        return new Fit(
                fit.model(), fit.runs(), fit.weights(), fit.causes(), fit.theta(), windows);
    }

    /** Gauss-Newton steps of whole runs, halved until they help. */
    static Fit converge(Fit start) {
        Fit best = start;
        double cost = start.cost();
        if (Double.isInfinite(cost)) {
            return best;
        }
        for (int s = 0; s < MOST_STEPS; s++) {
            List<Column> columns = best.columns();
            List<List<WindowBlock>> blocks =
                    Fit.blocks(best.runs(), best.derivatives(columns), 1);
            double before = cost;
            double share = 1;
            for (int h = 0; h < MOST_HALVINGS; h++) {
                Fit tried = moved(best, blocks, columns, share);
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
