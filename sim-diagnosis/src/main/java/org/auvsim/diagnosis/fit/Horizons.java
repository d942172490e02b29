package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.result.HorizonGain;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.List;

/** How far ahead a model predicts: from where short windows leave the measurement, onwards. */
final class Horizons {
    /** Shares of a run's duration; times are rounded to two figures. */
    private static final double[] SHARES = {0.02, 0.05, 0.1, 0.2, 0.5};

    /** Each so many of the short windows one prediction begins. */
    private static final int EVERY = 4;

    private final BelievedModel model;
    private final Noise noise;

    Horizons(BelievedModel model, Noise noise) {
        this.model = model;
        this.noise = noise;
    }

    /** Errors of held-out runs by time ahead, before and after. */
    List<HorizonGain> gains(List<Misses> data, Variant after) {
        double shortest = Double.POSITIVE_INFINITY;
        for (Misses of : data) {
            shortest = Math.min(shortest, of.run().duration());
        }
        List<HorizonGain> gains = new ArrayList<>();
        List<double[]> before = squares(data, model.variant(), shortest);
        List<double[]> with = squares(data, after, shortest);
        for (int s = 0; s < SHARES.length; s++) {
            if (before.get(1)[s] > 0 && with.get(1)[s] > 0) {
                gains.add(
                        new HorizonGain(
                                SHARES[s] * shortest,
                                new Gain(
                                        Math.sqrt(before.get(0)[s] / before.get(1)[s]),
                                        Math.sqrt(with.get(0)[s] / with.get(1)[s]),
                                        noise.of(Channel.POSITION))));
            }
        }
        return gains;
    }

    /** Sums of squared position errors (m^2) by share, and how many they are. */
    private List<double[]> squares(List<Misses> data, Variant variant, double shortest) {
        double[] sums = new double[SHARES.length];
        double[] counts = new double[SHARES.length];
        for (Misses of : data) {
            List<Window> windows = new Following(model, variant, of, noise).shortWindows();
            for (int w = 0; w < windows.size(); w += EVERY) {
                add(of, variant, windows.get(w), shortest, sums, counts);
            }
        }
        return List.of(sums, counts);
    }

    private void add(
            Misses of,
            Variant variant,
            Window window,
            double shortest,
            double[] sums,
            double[] counts) {
        int last = of.run().size() - 1;
        RigidMotion[] motion =
                Ensemble.simulate(
                        model,
                        of.run(),
                        window.from(),
                        last,
                        List.of(new Entrant(variant, window.start())))[0];
        double[] misses =
                of.plain(motion, variant.sensing(), window.from(), last - window.from() + 1);
        int rows = of.rows().size();
        for (int s = 0; s < SHARES.length; s++) {
            double until = of.run().time(window.to()) + SHARES[s] * shortest;
            for (int k = window.to(); k <= last; k++) {
                if (of.run().time(k) >= until) {
                    addSample(of, misses, (k - window.from()) * rows, s, sums, counts);
                    break;
                }
            }
        }
    }

    private void addSample(
            Misses of, double[] misses, int at, int share, double[] sums, double[] counts) {
        double square = 0;
        boolean isMeasured = false;
        for (int r = 0; r < of.rows().size(); r++) {
            if (of.rows().get(r).channel() == Channel.POSITION) {
                double off = misses[at + r] * noise.of(Channel.POSITION);
                square += off * off;
                isMeasured = true;
            }
        }
        if (isMeasured && Double.isFinite(square)) {
            sums[share] += square;
            counts[share]++;
        }
    }
}
