package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.result.HorizonGain;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Shooting;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.IntStream;

/**
 * How far ahead a model predicts, from states all along the held-out runs: those of the longest
 * windows in which the model with what was found follows the measurement, as they are known best.
 */
final class Horizons {
    /** Shares of the shortest run's duration. */
    private static final double[] SHARES = {0.02, 0.05, 0.1, 0.2, 0.5};

    /** So many predictions begin in each run. */
    private static final int BEGINNINGS = 8;

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
        List<List<Window>> begun = begun(data, after);
        HorizonErrors before = errors(data, begun, stepping.variant(), shortest);
        HorizonErrors with = errors(data, begun, after, shortest);
        List<HorizonGain> gains = new ArrayList<>();
        for (int h = 0; h < SHARES.length; h++) {
            Map<Channel, Gain> byChannel = byChannel(before, with, h);
            if (!byChannel.isEmpty()) {
                gains.add(new HorizonGain(SHARES[h] * shortest, byChannel));
            }
        }
        return gains;
    }

    private Map<Channel, Gain> byChannel(HorizonErrors before, HorizonErrors after, int horizon) {
        Map<Channel, Gain> gains = new EnumMap<>(Channel.class);
        for (Channel channel : Channel.values()) {
            OptionalDouble believed = before.of(channel, horizon);
            OptionalDouble found = after.of(channel, horizon);
            if (believed.isPresent() && found.isPresent()) {
                double of = noise.of(channel);
                gains.put(channel, new Gain(believed.getAsDouble(), found.getAsDouble(), of));
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

    private HorizonErrors errors(
            List<Misses> data, List<List<Window>> begun, Variant variant, double shortest) {
        return IntStream.range(0, data.size())
                .parallel()
                .mapToObj(
                        r -> {
                            Shooting shooting = new Shooting(stepping, variant, data.get(r));
                            HorizonErrors errors = new HorizonErrors(SHARES.length);
                            begun.get(r).forEach(window -> add(shooting, window, shortest, errors));
                            return errors;
                        })
                .toList()
                .stream() // added up in order: sums depend on it
                .reduce(new HorizonErrors(SHARES.length), HorizonErrors::plus);
    }

    private static void add(
            Shooting shooting, Window window, double shortest, HorizonErrors errors) {
        MeasuredRun run = shooting.of().run();
        RigidMotion[] motion = shooting.motion(window);
        boolean isLost = motion[0].equals(Ensemble.LOST);
        for (int h = 0; h < SHARES.length; h++) {
            double until = run.time(window.from()) + SHARES[h] * shortest;
            for (int k = window.from(); k <= window.to(); k++) {
                if (run.time(k) >= until) {
                    Window ahead = new Window(window.from(), k, window.start());
                    addLast(shooting, ahead, isLost ? shooting.motion(ahead) : motion, h, errors);
                    break;
                }
            }
        }
    }

    /** Adds the errors of a window's last sample; a motion that gets lost later may be longer. */
    private static void addLast(
            Shooting shooting,
            Window window,
            RigidMotion[] motion,
            int horizon,
            HorizonErrors errors) {
        Misses of = shooting.of();
        double[] misses =
                of.plain(motion, shooting.variant().sensing(), window.from(), motion.length);
        int rows = of.rows().size();
        for (int r = 0; r < rows; r++) {
            int number = window.to() * rows + r;
            if (of.counts(number)) {
                double error = of.error(number, misses[number - window.from() * rows]);
                errors.add(of.rows().get(r).channel(), horizon, error);
            }
        }
    }
}
