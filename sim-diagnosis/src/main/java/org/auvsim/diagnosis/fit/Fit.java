package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Sensing;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Outcome;
import org.auvsim.diagnosis.residual.Outcome.Squares;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.shooting.Shooting;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.diagnosis.shooting.WindowBlock;
import org.auvsim.diagnosis.shooting.WindowDerivatives;
import org.auvsim.diagnosis.shooting.WindowDerivatives.Moves;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * A hypothesis, and windows that follow the measurement under it. Immutable; a step leads to a
 * better one.
 *
 * @param stepping the model
 * @param data what motions miss of each run
 * @param windows of each run, in order
 * @param knowledge of the hypothesis's parameters beside these runs
 */
public record Fit(
        Stepping stepping,
        List<Misses> data,
        Hypothesis hypothesis,
        List<List<Window>> windows,
        Knowledge knowledge) {
    /** The model in the steps of predictions. */
    public BelievedModel model() {
        return stepping.model();
    }

    /** Windows of one of the runs under the hypothesis. */
    Shooting shooting(Misses of) {
        return new Shooting(stepping, variant(), of);
    }

    /** The model with the causes. */
    public Variant variant() {
        return hypothesis.in(stepping.variant());
    }

    /** The same runs by another hypothesis, from other windows. */
    public Fit with(Hypothesis other, List<List<Window>> moved) {
        return new Fit(stepping, data, other, moved, knowledge);
    }

    /** The model as it is believed from the same starts: what it would have foretold from there. */
    public Fit asBelieved() {
        return with(Hypothesis.NONE, windows);
    }

    /** The same of one of its runs alone. */
    public Fit ofRun(int run) {
        return new Fit(
                stepping, List.of(data.get(run)), hypothesis, List.of(windows.get(run)), knowledge);
    }

    /** The same in steps of other lengths. */
    public Fit in(Stepping other) {
        return new Fit(other, data, hypothesis, windows, knowledge);
    }

    /** The same with parameters of which something is known. */
    public Fit knowing(Knowledge other) {
        return new Fit(stepping, data, hypothesis, windows, other);
    }

    /** The same runs as its sensors see them: {@link Misses#seen}. */
    Fit asSeen() {
        Sensing sensing = variant().sensing();
        List<Misses> seen =
                IntStream.range(0, data.size())
                        .parallel()
                        .mapToObj(
                                r -> sensing.isPrompt() ? data.get(r).allSeen() : seen(r, sensing))
                        .toList();
        return seen.equals(data) ? this : new Fit(stepping, seen, hypothesis, windows, knowledge);
    }

    private Misses seen(int run, Sensing sensing) {
        Shooting shooting = shooting(data.get(run).allSeen());
        double[] misses =
                windows.get(run).stream()
                        .flatMapToDouble(w -> Arrays.stream(shooting.misses(w, shooting.motion(w))))
                        .toArray();
        return data.get(run).seen(sensing, misses);
    }

    /**
     * Derivatives by the starts of the windows and by the hypothesis's own parameters, run by run.
     */
    List<List<WindowDerivatives>> derivatives() {
        return derivatives(hypothesis.moves(stepping.variant()));
    }

    /** Those by the starts of the windows and by other parameters. */
    public List<List<WindowDerivatives>> derivatives(Moves moves) {
        return IntStream.range(0, data.size())
                .parallel()
                .mapToObj(r -> derivatives(shooting(data.get(r)), windows.get(r), moves))
                .toList();
    }

    private static List<WindowDerivatives> derivatives(
            Shooting shooting, List<Window> windows, Moves moves) {
        return windows.parallelStream().map(w -> shooting.derivatives(w, 1, moves)).toList();
    }

    /** Windows chained in blocks of so many; known starts hold the first of each run. */
    public List<List<WindowBlock>> blocks(List<List<WindowDerivatives>> derivatives, int perBlock) {
        List<List<WindowBlock>> all = new ArrayList<>();
        for (int r = 0; r < data.size(); r++) {
            List<WindowDerivatives> ofRun = derivatives.get(r);
            List<WindowBlock> blocks = new ArrayList<>();
            for (int w = 0; w < ofRun.size(); w += perBlock) {
                blocks.add(
                        new WindowBlock(
                                model(),
                                ofRun.subList(w, Math.min(ofRun.size(), w + perBlock)),
                                data.get(r).shown(ofRun.get(w).window.from()),
                                w == 0 ? data.get(r).run().start() : Optional.empty()));
            }
            all.add(blocks);
        }
        return all;
    }

    /** Most windows of a run. */
    public int longest() {
        return windows.stream().mapToInt(List::size).max().orElse(1);
    }

    /** One window a run, from the start of its first. */
    public Fit whole() {
        return with(
                hypothesis,
                IntStream.range(0, data.size()).mapToObj(r -> List.of(whole(r))).toList());
    }

    /** The same windows, each begun where another fit's motion is then. */
    public Fit along(Fit other) {
        List<RigidMotion[]> motions = other.motions();
        return with(
                hypothesis,
                IntStream.range(0, data.size())
                        .mapToObj(
                                r ->
                                        windows.get(r).stream()
                                                .map(w -> w.startingAt(motions.get(r)[w.from()]))
                                                .toList())
                        .toList());
    }

    /** The motion of each run, simulated in one go from its start. */
    public List<RigidMotion[]> motions() {
        return IntStream.range(0, data.size())
                .parallel()
                .mapToObj(r -> shooting(data.get(r)).motion(whole(r)))
                .toList();
    }

    private Window whole(int run) {
        RigidMotion start = windows.get(run).getFirst().start();
        return new Window(0, data.get(run).run().size() - 1, start);
    }

    /** By how much that is off by channel, in its unit, however far; but for outliers. */
    public Map<Channel, Squares> errors() {
        List<RigidMotion[]> motions = motions();
        Variant variant = variant();
        Map<Channel, Squares> errors = new EnumMap<>(Channel.class);
        for (int r = 0; r < data.size(); r++) {
            Misses of = data.get(r);
            double[] off = of.plain(motions.get(r), variant.sensing(), 0, of.run().size());
            for (int row = 0; row < of.rows().size(); row++) {
                errors.merge(of.rows().get(row).channel(), errors(of, off, row), Squares::plus);
            }
        }
        return errors;
    }

    private static Squares errors(Misses of, double[] off, int row) {
        double sum = 0;
        int count = 0;
        for (int i = row; i < off.length; i += of.rows().size()) {
            if (of.counts(i)) {
                double error = of.error(i, off[i]);
                sum += error * error;
                count++;
            }
        }
        return new Squares(sum, count);
    }

    /** Sum of squares of the same, in standard deviations of the noise alone, whatever lasts. */
    public double squares() {
        List<RigidMotion[]> motions = motions();
        Variant variant = variant();
        double sum = 0;
        for (int r = 0; r < data.size(); r++) {
            Misses of = data.get(r);
            sum += Outcome.squares(of.plain(motions.get(r), variant.sensing(), 0, of.run().size()));
        }
        return sum;
    }

    /** What the start of a run misses of what is known of it; empty where nothing is. */
    public double[] startMisses(int run) {
        RigidMotion start = windows.get(run).getFirst().start();
        return data.get(run)
                .run()
                .start()
                .map(known -> Outcome.misses(known, start))
                .orElse(new double[0]);
    }

    /** What that misses. */
    public Outcome outcome() {
        return outcome(motions());
    }

    /** The same where the motion of each run is known. */
    Outcome outcome(List<RigidMotion[]> motions) {
        Variant variant = variant();
        List<double[]> misses = new ArrayList<>();
        double prior = knowledge.cost(hypothesis.numbers());
        for (int r = 0; r < data.size(); r++) {
            Misses of = data.get(r);
            misses.add(of.of(motions.get(r), variant.sensing(), 0, of.run().size()));
            RigidMotion start = windows.get(r).getFirst().start();
            prior += of.run().start().map(known -> Outcome.squares(known, start)).orElse(0.0);
        }
        return Outcome.of(data, misses, prior);
    }
}
