package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.diagnosis.shooting.WindowBlock;
import org.auvsim.diagnosis.shooting.WindowDerivatives;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * A step to where a fit should miss least, as far as derivatives tell: of its parameters, and of
 * the starts of its blocks of windows.
 */
public final class Step {
    /** A step turns no window by more (rad): beyond that it is not linear. */
    private static final double MOST_TURN = 0.7;

    /** Share of the largest column that others are damped by at least. */
    private static final double LEAST = 0.1;

    private final Fit from;
    private final List<List<WindowBlock>> blocks;
    private final Gram gram;
    private final double[] change;
    private final double turn;

    private Step(Fit from, List<List<WindowBlock>> blocks, Gram gram, double[] change) {
        this.from = from;
        this.blocks = blocks;
        this.gram = gram;
        this.change = change;
        this.turn = largestTurn(blocks, change);
    }

    /**
     * From a fit, its windows in blocks of so many; empty if the motion gets lost in a window, or
     * what parameters do to it is out of bounds.
     */
    static Optional<Step> of(Fit fit, Tangents tangents, int perBlock) {
        List<List<WindowDerivatives>> derivatives = tangents.derivatives();
        for (List<WindowDerivatives> ofRun : derivatives) {
            if (ofRun.stream().anyMatch(WindowDerivatives::isLost)) {
                return Optional.empty();
            }
        }
        Step step = of(fit, fit.blocks(derivatives, perBlock), 0);
        return Optional.of(step).filter(s -> s.gram.isFinite());
    }

    private static Step of(Fit fit, List<List<WindowBlock>> blocks, double damping) {
        int size = fit.hypothesis().size();
        Gram gram =
                Gram.of(blocks, size)
                        .with(fit.knowledge(), fit.hypothesis().numbers())
                        .cautious(fit.hypothesis().parameters());
        return new Step(fit, blocks, gram, solved(fit, gram, damping));
    }

    private static double[] solved(Fit fit, Gram gram, double damping) {
        Hypothesis of = fit.hypothesis();
        return damping == 0
                ? gram.solve(all(of.size()), of.bounds())
                : gram.solve(all(of.size()), of.bounds(), damping, least(of, gram));
    }

    /** Sizes of columns that are a share of the largest, each by its parameter's scale. */
    private static double[] least(Hypothesis of, Gram gram) {
        List<Parameter> parameters = of.parameters();
        double largest = 0;
        for (int i = 0; i < parameters.size(); i++) {
            largest = Math.max(largest, gram.norm(i) * parameters.get(i).scale());
        }
        double[] least = new double[parameters.size()];
        for (int i = 0; i < least.length; i++) {
            least[i] = LEAST * largest / parameters.get(i).scale();
        }
        return least;
    }

    private static int[] all(int size) {
        return IntStream.range(0, size).toArray();
    }

    /** The same, shorter along what is hardly determined (Marquardt 1963). */
    Step damped(double damping) {
        return new Step(from, blocks, gram, solved(from, gram, damping));
    }

    /** The same, that of the starts shorter, too. */
    Step held(double damping) {
        List<List<WindowBlock>> heldBack =
                blocks.stream()
                        .map(ofRun -> ofRun.stream().map(block -> block.damped(damping)).toList())
                        .toList();
        return of(from, heldBack, damping);
    }

    /** Whether it moves parameters, or starts alone. */
    boolean hasParameters() {
        return change.length > 0;
    }

    /** By how much (rad) the window that turns most does so. */
    double turn() {
        return turn;
    }

    /** What would be missed after it, the starts of all blocks free. */
    double least() {
        return gram.cost() - gram.drop(all(change.length), change);
    }

    /** Where it leads, as far as it is linear. */
    Fit end() {
        return end(1);
    }

    /** Where a share of that leads. */
    Fit end(double share) {
        double all = share * linear(turn);
        double[] gone = new double[change.length];
        for (int i = 0; i < gone.length; i++) {
            gone[i] = all * change[i];
        }
        return from.with(from.hypothesis().plus(gone), windows(blocks, change, all));
    }

    /** Windows moved as a change of parameters asks for, as far as that is linear. */
    public static List<List<Window>> windows(List<List<WindowBlock>> blocks, double[] change) {
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
}
