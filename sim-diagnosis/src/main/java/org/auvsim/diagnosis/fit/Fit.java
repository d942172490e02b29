package org.auvsim.diagnosis.fit;

import org.auvsim.core.step.StepException;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.WindowDerivatives.Column;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * A set of causes with parameters, and windows that follow the measurement under the model that has
 * them. Immutable; a step leads to a better one.
 *
 * @param windows of each run, in order
 */
record Fit(
        BelievedModel model,
        List<MeasuredRun> runs,
        Weights weights,
        List<Cause> causes,
        List<double[]> theta,
        List<List<Window>> windows) {
    /** The model with the causes. */
    Variant variant() {
        Variant variant = model.variant();
        for (int i = 0; i < causes.size(); i++) {
            variant = causes.get(i).in(variant, theta.get(i));
        }
        return variant;
    }

    /** The columns of the parameters of the causes. */
    List<Column> columns() {
        return columns(causes);
    }

    static List<Column> columns(List<Cause> causes) {
        List<Column> columns = new ArrayList<>();
        for (Cause cause : causes) {
            for (int p = 0; p < cause.parameters().size(); p++) {
                columns.add(new Column(cause, p));
            }
        }
        return columns;
    }

    /** The same, its windows as they are, with derivatives by these parameters, run by run. */
    List<List<WindowDerivatives>> derivatives(List<Column> columns) {
        Variant variant = variant();
        List<List<WindowDerivatives>> all = new ArrayList<>();
        for (int r = 0; r < runs.size(); r++) {
            MeasuredRun run = runs.get(r);
            List<Window> ofRun = windows.get(r);
            all.add(
                    IntStream.range(0, ofRun.size())
                            .parallel()
                            .mapToObj(
                                    w ->
                                            WindowDerivatives.of(
                                                    model,
                                                    variant,
                                                    run,
                                                    weights,
                                                    ofRun.get(w),
                                                    w == ofRun.size() - 1,
                                                    columns))
                            .toList());
        }
        return all;
    }

    /** Windows chained in blocks of so many; known starts hold the first of each run. */
    static List<List<WindowBlock>> blocks(
            List<MeasuredRun> runs, List<List<WindowDerivatives>> derivatives, int perBlock) {
        List<List<WindowBlock>> all = new ArrayList<>();
        for (int r = 0; r < runs.size(); r++) {
            List<WindowDerivatives> ofRun = derivatives.get(r);
            List<WindowBlock> blocks = new ArrayList<>();
            for (int w = 0; w < ofRun.size(); w += perBlock) {
                blocks.add(
                        new WindowBlock(
                                ofRun.subList(w, Math.min(ofRun.size(), w + perBlock)),
                                w == 0 ? runs.get(r).start() : Optional.empty()));
            }
            all.add(blocks);
        }
        return all;
    }

    /** Simulated in one go from the start of each run: the misses, in standard deviations. */
    double cost() {
        try {
            return simulatedCost();
        } catch (StepException e) {
            return Double.POSITIVE_INFINITY; // so far off that no step can be made
        }
    }

    private double simulatedCost() {
        double cost = 0;
        Variant variant = variant();
        for (int r = 0; r < runs.size(); r++) {
            MeasuredRun run = runs.get(r);
            RigidMotion[] motion =
                    Ensemble.simulate(
                            model,
                            run,
                            0,
                            run.size() - 1,
                            List.of(new Entrant(variant, windows.get(r).getFirst().start())))[0];
            double[] misses = new double[Weights.ROWS];
            for (int k = 0; k < run.size(); k++) {
                weights.residuals(run.samples().get(k), motion[k], misses, 0);
                for (double miss : misses) {
                    cost += miss * miss;
                }
            }
        }
        return cost;
    }
}
