package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.model.Partings;
import org.auvsim.diagnosis.model.Partings.Leg;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.shooting.LegResponse;
import org.auvsim.diagnosis.shooting.Shooting;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.diagnosis.shooting.WindowDerivatives;
import org.auvsim.diagnosis.shooting.WindowDerivatives.Moves;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Derivatives of a run's windows by very many parameters, at a fraction of a simulation each: in
 * short legs that all begin on the model's own motion, each parameter parts a variant from the
 * model; the model's transitions carry that on (variation of constants). What a parameter does to
 * the sensors is seen from the model's motion itself. Where errors of measurements last, what is
 * missed in a leg depends on those before: then whole windows are simulated.
 */
public final class FirstOrder {
    private final Shooting shooting;
    private final Variant variant;
    private final Misses of;
    private final Moves moves;
    private final int perLeg;

    /** Samples that are taken together: those of two legs, or single ones. */
    private final int group;

    private FirstOrder(Fit fit, Misses of, Moves moves) {
        this.shooting = fit.shooting(of);
        this.variant = shooting.variant();
        this.of = of;
        this.moves = moves;
        double apart = of.run().duration() / (of.run().size() - 1);
        perLeg = Math.max(1, (int) Math.floor(Partings.SHORT / apart + 1e-9));
        group = apart > Partings.SHORT ? 1 : 2 * perLeg;
    }

    /** Those of all windows of a fit, run by run. */
    public static List<List<WindowDerivatives>> derivatives(Fit fit, Moves moves) {
        List<List<WindowDerivatives>> all = new ArrayList<>();
        for (int r = 0; r < fit.data().size(); r++) {
            all.add(new FirstOrder(fit, fit.data().get(r), moves).windows(fit.windows().get(r)));
        }
        return all;
    }

    private List<WindowDerivatives> windows(List<Window> windows) {
        if (of.hasLastingErrors()) {
            return derivatives(windows, moves);
        }
        List<WindowDerivatives> byStarts = derivatives(windows, Moves.NONE);
        if (byStarts.stream().anyMatch(WindowDerivatives::isLost)) {
            return byStarts.stream().map(this::ofNothing).toList();
        }
        List<Leg> legs = new ArrayList<>();
        int[] firstLeg = new int[windows.size()];
        for (int w = 0; w < firstLeg.length; w++) {
            firstLeg[w] = legs.size();
            legs.addAll(legs(byStarts.get(w)));
        }
        double[][][] partings = partings(legs);
        return IntStream.range(0, firstLeg.length)
                .parallel()
                .mapToObj(w -> along(byStarts.get(w), legs, firstLeg[w], partings))
                .toList();
    }

    /** Those by whole simulations. */
    private List<WindowDerivatives> derivatives(List<Window> windows, Moves by) {
        return windows.parallelStream().map(w -> shooting.derivatives(w, group, by)).toList();
    }

    private WindowDerivatives ofNothing(WindowDerivatives window) {
        return window.by(
                new double[moves.size()][window.misses.length],
                new double[moves.size()][RigidMotion.SIZE]);
    }

    private List<Leg> legs(WindowDerivatives window) {
        List<Leg> legs = new ArrayList<>();
        int from = window.window.from();
        for (int k = from; k < window.window.to(); k += perLeg) {
            int to = Math.min(k + perLeg, window.window.to());
            legs.add(new Leg(k, to, window.motion[k - from], window.motion[to - from]));
        }
        return legs;
    }

    /** By parameter and leg; no legs of a parameter that leaves body and water as they are. */
    private double[][][] partings(List<Leg> legs) {
        List<Variant> moving = moves.variants().stream().filter(this::movesOtherwise).toList();
        double[][][] ofMoving =
                moving.isEmpty()
                        ? new double[0][][]
                        : Partings.of(shooting.stepping().model(), of.run(), legs, variant, moving);
        double[][][] all = new double[moves.size()][][];
        int next = 0;
        for (int p = 0; p < all.length; p++) {
            all[p] = movesOtherwise(moves.variants().get(p)) ? ofMoving[next++] : new double[0][];
        }
        return all;
    }

    private boolean movesOtherwise(Variant other) {
        return !other.movesAs(variant);
    }

    private WindowDerivatives along(
            WindowDerivatives window, List<Leg> legs, int firstLeg, double[][][] partings) {
        int count = legs(window).size();
        int samples = window.window.samples(of.run());
        List<LegResponse> responses = new ArrayList<>();
        for (int l = 0; l < count; l++) {
            Leg leg = legs.get(firstLeg + l);
            responses.add(response(leg, leg.to() - leg.from(), window.window, samples));
        }
        if (samples > window.window.length()) {
            int last = window.window.to();
            Leg end = new Leg(last, last, window.end, window.end);
            responses.add(response(end, 1, window.window, samples));
        }
        double[][] byParameter = new double[moves.size()][];
        double[][] endByParameter = new double[moves.size()][];
        for (int p = 0; p < moves.size(); p++) {
            double[] rows = sensed(window, moves.variants().get(p), samples);
            double[] error = new double[RigidMotion.SIZE];
            if (partings[p].length > 0) {
                carry(
                        responses,
                        window,
                        Arrays.asList(partings[p]).subList(firstLeg, firstLeg + count),
                        rows,
                        error);
            }
            double step = moves.steps().get(p);
            byParameter[p] = Shooting.slope(rows, new double[rows.length], step);
            endByParameter[p] = Shooting.slope(error, new double[error.length], step);
        }
        return window.by(byParameter, endByParameter);
    }

    private LegResponse response(Leg leg, int samples, Window window, int ofWindow) {
        int first = (leg.from() - window.from()) / group * group;
        double[] weights = of.together(window.from() + first, Math.min(group, ofWindow - first));
        return new LegResponse(shooting, leg, samples, weights);
    }

    private void carry(
            List<LegResponse> responses,
            WindowDerivatives window,
            List<double[]> partings,
            double[] rows,
            double[] error) {
        int width = of.rows().size();
        for (int l = 0; l < responses.size(); l++) {
            boolean isEnd = l == partings.size();
            int sample = isEnd ? window.window.length() : l * perLeg;
            responses
                    .get(l)
                    .carry(
                            error,
                            isEnd ? new double[RigidMotion.SIZE] : partings.get(l),
                            rows,
                            sample / group * width);
        }
    }

    /** What other sensors would tell of the same motion. */
    private double[] sensed(WindowDerivatives window, Variant other, int samples) {
        double[] rows = new double[window.misses.length];
        if (!other.sensing().equals(variant.sensing())) {
            double[] told =
                    of.of(window.motion, other.sensing(), window.window.from(), samples, group);
            for (int k = 0; k < rows.length; k++) {
                rows[k] = told[k] - window.misses[k];
            }
        }
        return rows;
    }
}
