package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.result.HorizonGain;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * How far ahead a model predicts, from states all along the held-out runs: those of the longest
 * windows in which the model with what was found follows the measurement, as they are known best.
 */
final class Horizons {
    /** Shares of a run's duration; times are rounded to two figures. */
    private static final double[] SHARES = {0.02, 0.05, 0.1, 0.2, 0.5};

    /** So many predictions begin in each run. */
    private static final int BEGINNINGS = 8;

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
        List<List<Window>> begun = begun(data, after);
        List<double[]> before = squares(data, begun, stepping.variant(), shortest);
        List<double[]> with = squares(data, begun, after, shortest);
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

    /** From where on each run is predicted, to its end. */
    private List<List<Window>> begun(List<Misses> data, Variant after) {
        return data.parallelStream().map(of -> begun(new Shooting(stepping, after, of))).toList();
    }

    private List<Window> begun(Shooting shooting) {
        int last = shooting.of().run().size() - 1;
        List<Window> begun = new ArrayList<>();
        for (Window window : new Following(shooting, noise).windows()) {
            RigidMotion[] motion = shooting.motion(window);
            for (int b = 0; b < BEGINNINGS; b++) {
                int from = b * last / BEGINNINGS;
                boolean isWithin = window.from() <= from && from < window.to();
                if (isWithin && !motion[0].equals(Ensemble.LOST)) {
                    begun.add(new Window(from, last, motion[from - window.from()]));
                }
            }
        }
        return begun;
    }

    /** Sums of squared position errors (m^2) by share, and how many they are. */
    private List<double[]> squares(
            List<Misses> data, List<List<Window>> begun, Variant variant, double shortest) {
        return IntStream.range(0, data.size())
                .parallel()
                .mapToObj(
                        r -> {
                            Shooting shooting = new Shooting(stepping, variant, data.get(r));
                            return squares(shooting, begun.get(r), shortest);
                        })
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

    private static List<double[]> squares(Shooting shooting, List<Window> begun, double shortest) {
        double[] sums = new double[SHARES.length];
        double[] counts = new double[SHARES.length];
        begun.forEach(window -> add(shooting, window, shortest, sums, counts));
        return List.of(sums, counts);
    }

    private static void add(
            Shooting shooting, Window window, double shortest, double[] sums, double[] counts) {
        Misses of = shooting.of();
        RigidMotion[] motion = shooting.motion(window);
        double[] misses =
                of.plain(motion, shooting.variant().sensing(), window.from(), motion.length);
        for (int s = 0; s < SHARES.length; s++) {
            double until = of.run().time(window.from()) + SHARES[s] * shortest;
            for (int k = window.from(); k <= window.to(); k++) {
                if (of.run().time(k) >= until) {
                    addSample(of, misses, k, window.from(), s, sums, counts);
                    break;
                }
            }
        }
    }

    private static void addSample(
            Misses of,
            double[] misses,
            int sample,
            int from,
            int share,
            double[] sums,
            double[] counts) {
        double square = 0;
        boolean isMeasured = false;
        int rows = of.rows().size();
        for (int r = 0; r < rows; r++) {
            if (of.rows().get(r).channel() == Channel.POSITION) {
                double miss = misses[(sample - from) * rows + r];
                double off = miss * of.deviation(sample * rows + r);
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
