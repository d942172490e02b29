package org.auvsim.diagnosis.fit;

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

    private static final List<double[]> NOTHING =
            List.of(new double[SHARES.length], new double[SHARES.length]);

    private final Stepping stepping;
    private final Noise noise;

    Horizons(Stepping stepping, Noise noise) {
        this.stepping = stepping;
        this.noise = noise;
    }

    /** Errors of held-out runs by time ahead, before and after. */
    List<HorizonGain> gains(List<Misses> data, Variant after) {
        double shortest = Double.POSITIVE_INFINITY;
        for (Misses of : data) {
            shortest = Math.min(shortest, of.run().duration());
        }
        List<HorizonGain> gains = new ArrayList<>();
        List<double[]> before = squares(data, stepping.variant(), shortest);
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
        return data.parallelStream()
                .map(of -> squares(new Shooting(stepping, variant, of), shortest))
                .reduce(NOTHING, Horizons::sum);
    }

    private static List<double[]> sum(List<double[]> some, List<double[]> others) {
        List<double[]> sum = new ArrayList<>();
        for (int i = 0; i < some.size(); i++) {
            double[] both = some.get(i).clone();
            for (int s = 0; s < both.length; s++) {
                both[s] += others.get(i)[s];
            }
            sum.add(both);
        }
        return sum;
    }

    private List<double[]> squares(Shooting shooting, double shortest) {
        double[] sums = new double[SHARES.length];
        double[] counts = new double[SHARES.length];
        List<Window> windows = new Following(shooting, noise).shortWindows();
        for (int w = 0; w < windows.size(); w += EVERY) {
            add(shooting, windows.get(w), shortest, sums, counts);
        }
        return List.of(sums, counts);
    }

    private void add(
            Shooting shooting, Window begin, double shortest, double[] sums, double[] counts) {
        Misses of = shooting.of();
        int last = of.run().size() - 1;
        Window window = new Window(begin.from(), last, begin.start());
        RigidMotion[] motion = shooting.motion(window);
        double[] misses =
                of.plain(motion, shooting.variant().sensing(), begin.from(), motion.length);
        int rows = of.rows().size();
        for (int s = 0; s < SHARES.length; s++) {
            double until = of.run().time(begin.to()) + SHARES[s] * shortest;
            for (int k = begin.to(); k <= last; k++) {
                if (of.run().time(k) >= until) {
                    addSample(of, misses, (k - begin.from()) * rows, s, sums, counts);
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
