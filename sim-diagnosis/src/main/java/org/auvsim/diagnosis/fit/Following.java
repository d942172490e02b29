package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.fit.WindowDerivatives.Moves;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Cuts a run into windows in which the model follows the measurement: many short ones at first,
 * then twice as long ones, as long as the model can follow. A model without faults needs one
 * window; one that lacks much keeps many.
 */
final class Following {
    private static final int MOST_WINDOWS = 32;
    private static final int FEWEST_SAMPLES = 8;
    private static final int FIRST_SAMPLES = 6;
    private static final int MOST_ITERATIONS = 12;
    private static final int MOST_HALVINGS = 6;

    /** A window follows if its misses, without the noise, are below the larger of these. */
    private static final double SHARE_OF_RANGE = 0.003;

    private static final double SHARE_OF_NOISE = 0.7;
    private static final double TURN = 0.06;

    private final BelievedModel model;
    private final Variant variant;
    private final MeasuredRun run;
    private final Misses data;
    private final Noise noise;

    /** The model in a variant, and what motions miss of a run. */
    Following(BelievedModel model, Variant variant, Misses data, Noise noise) {
        this.model = model;
        this.variant = variant;
        this.run = data.run();
        this.data = data;
        this.noise = noise;
    }

    /** Windows that follow runs under a hypothesis. */
    static Fit of(BelievedModel model, Hypothesis hypothesis, List<Misses> data, Noise noise) {
        Variant variant = hypothesis.in(model.variant());
        List<List<Window>> windows =
                data.stream()
                        .map(run -> new Following(model, variant, run, noise).windows())
                        .toList();
        return new Fit(model, data, hypothesis, windows, Knowledge.NONE);
    }

    /** A window as it was fitted, and by how much it misses: chi squared of its samples. */
    private record Fitted(Window window, WindowDerivatives derivatives) {
        double cost() {
            return derivatives.cost();
        }
    }

    /** Many short windows, each fitted alone: they follow whatever moves the body. */
    List<Window> shortWindows() {
        return fitAll(borders(mostWindows()), Optional.empty()).stream()
                .map(Fitted::window)
                .toList();
    }

    private int mostWindows() {
        int count = MOST_WINDOWS;
        while (count > 1 && (run.size() - 1) / count < FEWEST_SAMPLES) {
            count /= 2;
        }
        return count;
    }

    /** The longest windows in which the model follows, of equal length but for the last. */
    List<Window> windows() {
        List<Fitted> fitted = fitAll(borders(mostWindows()), Optional.empty());
        while (fitted.size() > 1) {
            List<Fitted> longer = fitAll(borders(fitted.size() / 2), Optional.of(fitted));
            if (!follows(longer)) {
                break;
            }
            fitted = longer;
        }
        return fitted.stream().map(Fitted::window).toList();
    }

    private int[] borders(int count) {
        int[] borders = new int[count + 1];
        for (int i = 0; i <= count; i++) {
            borders[i] = (int) ((long) i * (run.size() - 1) / count);
        }
        return borders;
    }

    private List<Fitted> fitAll(int[] borders, Optional<List<Fitted>> shorter) {
        return IntStream.range(0, borders.length - 1)
                .parallel()
                .mapToObj(w -> fit(borders, w, shorter))
                .toList();
    }

    private Fitted fit(int[] borders, int w, Optional<List<Fitted>> shorter) {
        int from = borders[w];
        int to = borders[w + 1];
        boolean isLast = w == borders.length - 2;
        Optional<KnownStart> known = w == 0 ? run.start() : Optional.empty();
        Window first =
                shorter.map(s -> s.get(2 * w).window())
                        .map(s -> new Window(from, to, s.start()))
                        .orElseGet(() -> firstGuess(from, to, isLast, known));
        return fit(first, isLast, known);
    }

    /** By the first few samples alone. */
    private Window firstGuess(int from, int to, boolean isLast, Optional<KnownStart> known) {
        int near = Math.min(to, from + FIRST_SAMPLES);
        Window guess =
                new Window(
                        from,
                        near,
                        known.map(KnownStart::motion)
                                .orElseGet(() -> LocalMotion.at(run, model.start(), from, near)));
        Window fitted = fit(guess, isLast && near == to, known).window();
        return new Window(from, to, fitted.start());
    }

    /** Gauss-Newton steps, halved until they help. */
    private Fitted fit(Window start, boolean isLast, Optional<KnownStart> known) {
        Fitted best = derive(start, isLast);
        for (int iteration = 0; iteration < MOST_ITERATIONS; iteration++) {
            WindowBlock block =
                    new WindowBlock(model, List.of(best.derivatives()), data.shown(), known);
            double before = best.cost();
            Fitted next = best;
            double share = 1;
            for (int halving = 0; halving < MOST_HALVINGS; halving++) {
                Fitted tried = derive(block.moved(new double[0], share).getFirst(), isLast);
                if (tried.cost() < best.cost()) {
                    next = tried;
                    break;
                }
                share /= 2;
            }
            best = next;
            if (!(best.cost() < before * (1 - 1e-4))) {
                break;
            }
        }
        return best;
    }

    private Fitted derive(Window window, boolean isLast) {
        return new Fitted(
                window, WindowDerivatives.of(model, variant, data, window, isLast, 1, Moves.NONE));
    }

    private boolean follows(List<Fitted> fitted) {
        for (Channel channel : List.of(Channel.POSITION, Channel.ORIENTATION)) {
            double allowed =
                    channel == Channel.POSITION
                            ? Math.max(SHARE_OF_RANGE * range(), SHARE_OF_NOISE * noise.of(channel))
                            : Math.max(TURN, SHARE_OF_NOISE * noise.of(channel));
            for (Fitted window : fitted) {
                if (systematic(window.derivatives().misses, channel) * noise.of(channel)
                        > allowed) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Root of what the mean square miss has beyond noise, in standard deviations. */
    private double systematic(double[] misses, Channel channel) {
        List<Misses.Row> rows = data.rows();
        double sum = 0;
        int count = 0;
        for (int i = 0; i < misses.length; i++) {
            if (rows.get(i % rows.size()).channel() == channel) {
                sum += misses[i] * misses[i];
                count++;
            }
        }
        return count == 0 ? 0 : Math.sqrt(Math.max(0, sum / count - 1));
    }

    /** The largest extent of the motion along an axis (m). */
    private double range() {
        double range = 0;
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int k = 0; k < run.size(); k++) {
                double place = run.value(Channel.POSITION, k, axis);
                if (!Double.isNaN(place)) {
                    low = Math.min(low, place);
                    high = Math.max(high, place);
                }
            }
            range = Math.max(range, high - low);
        }
        return range;
    }
}
