package org.auvsim.diagnosis.fit;

import org.auvsim.core.step.StepException;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * A hypothesis, and windows that follow the measurement under it. Immutable; a step leads to a
 * better one.
 *
 * @param data what motions miss of each run
 * @param windows of each run, in order
 */
record Fit(
        BelievedModel model, List<Misses> data, Hypothesis hypothesis, List<List<Window>> windows) {
    /** The model with the causes. */
    Variant variant() {
        return hypothesis.in(model.variant());
    }

    Fit with(Hypothesis other, List<List<Window>> moved) {
        return new Fit(model, data, other, moved);
    }

    /** Derivatives by the starts of the windows and by parameters, run by run. */
    List<List<WindowDerivatives>> derivatives(List<Variant> moved, double[] steps) {
        Variant variant = variant();
        List<List<WindowDerivatives>> all = new ArrayList<>();
        for (int r = 0; r < data.size(); r++) {
            Misses of = data.get(r);
            List<Window> ofRun = windows.get(r);
            all.add(
                    IntStream.range(0, ofRun.size())
                            .parallel()
                            .mapToObj(
                                    w ->
                                            WindowDerivatives.of(
                                                    model,
                                                    variant,
                                                    of,
                                                    ofRun.get(w),
                                                    w == ofRun.size() - 1,
                                                    moved,
                                                    steps))
                            .toList());
        }
        return all;
    }

    /** Derivatives by the hypothesis's own parameters. */
    List<List<WindowDerivatives>> derivatives() {
        return derivatives(hypothesis.moved(model.variant()), hypothesis.steps());
    }

    /** Windows chained in blocks of so many; known starts hold the first of each run. */
    List<List<WindowBlock>> blocks(List<List<WindowDerivatives>> derivatives, int perBlock) {
        List<List<WindowBlock>> all = new ArrayList<>();
        for (int r = 0; r < data.size(); r++) {
            List<WindowDerivatives> ofRun = derivatives.get(r);
            List<WindowBlock> blocks = new ArrayList<>();
            for (int w = 0; w < ofRun.size(); w += perBlock) {
                blocks.add(
                        new WindowBlock(
                                ofRun.subList(w, Math.min(ofRun.size(), w + perBlock)),
                                w == 0 ? data.get(r).run().start() : Optional.empty()));
            }
            all.add(blocks);
        }
        return all;
    }

    /** Most windows of a run. */
    int longest() {
        return windows.stream().mapToInt(List::size).max().orElse(1);
    }

    /** Simulated in one go from the start of each run: squared misses in all. */
    double cost() {
        try {
            double cost = 0;
            for (double[] ofRun : misses()) {
                for (double miss : ofRun) {
                    cost += miss * miss;
                }
            }
            return cost;
        } catch (StepException e) {
            return Double.POSITIVE_INFINITY; // so far off that no step can be made
        }
    }

    /** Simulated in one go from the start of each run: the misses of each. */
    List<double[]> misses() {
        Variant variant = variant();
        List<double[]> all = new ArrayList<>();
        for (int r = 0; r < data.size(); r++) {
            Misses of = data.get(r);
            int last = of.run().size() - 1;
            RigidMotion[] motion =
                    Ensemble.simulate(
                            model,
                            of.run(),
                            0,
                            last,
                            List.of(new Entrant(variant, windows.get(r).getFirst().start())))[0];
            all.add(of.of(motion, variant.sensing(), 0, last + 1));
        }
        return all;
    }
}
