package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Guess;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Looks for the causes that explain what a model misses of measured runs. */
public final class Search {
    private static final int KEPT = 5;
    private static final double PER_CAUSE = 12;

    private final BelievedModel model;
    private final Noise noise;
    private final List<Misses> data;
    private final int count;
    private final List<Seed> seeds = new ArrayList<>();

    /** What one set of causes makes of the runs; the smaller the score, the better. */
    public record Candidate(List<String> causes, List<double[]> theta, double cost, double score) {}

    /** A guess of a cause, and the first of its columns. */
    private record Seed(Cause cause, Guess guess, int first) {
        int[] columns() {
            int[] columns = new int[guess.columns().size()];
            for (int i = 0; i < columns.length; i++) {
                columns[i] = first + i;
            }
            return columns;
        }
    }

    record Scored(Fit fit, double cost, double score) {}

    public Search(BelievedModel model, List<MeasuredRun> runs, List<Cause> library) {
        this.model = model;
        this.noise = Noise.of(runs);
        this.data = runs.stream().map(run -> new Misses(run, noise)).toList();
        this.count = data.stream().mapToInt(Misses::count).sum();
        int first = 0;
        for (Cause cause : library) {
            for (Guess guess : cause.guesses(runs)) {
                seeds.add(new Seed(cause, guess, first));
                first += guess.columns().size();
            }
        }
    }

    /** Sets of causes, the best first. */
    public List<Candidate> candidates() {
        Fit base =
                new Fit(
                        model,
                        data,
                        Hypothesis.NONE,
                        data.stream().map(of -> new Following(model, of, noise).windows()).toList());
        List<Scored> scored = new ArrayList<>();
        scored.add(scored(Refinement.refine(base, 1)));
        for (Fit start : screen(base)) {
            scored.add(scored(Refinement.refine(start, 1)));
        }
        scored.sort(Comparator.comparingDouble(Scored::score));
        return scored.stream()
                .map(
                        s ->
                                new Candidate(
                                        s.fit().hypothesis().causes().stream()
                                                .map(Cause::id)
                                                .toList(),
                                        s.fit().hypothesis().theta(),
                                        s.cost(),
                                        s.score()))
                .toList();
    }

    private Scored scored(Fit fit) {
        double cost = fit.cost();
        double score =
                count * Math.log(cost / count)
                        + fit.hypothesis().size() * Math.log(count)
                        + PER_CAUSE * fit.hypothesis().causes().size();
        return new Scored(fit, cost, score);
    }

    /** The singles and pairs that promise most, by the linearised runs. */
    private List<Fit> screen(Fit base) {
        List<Variant> moved = new ArrayList<>();
        List<Double> steps = new ArrayList<>();
        for (Seed seed : seeds) {
            for (int i = 0; i < seed.guess().columns().size(); i++) {
                double[] theta =
                        seed.guess().theta().stream().mapToDouble(Double::doubleValue).toArray();
                theta[seed.guess().columns().get(i)] += seed.guess().steps().get(i);
                moved.add(seed.cause().in(model.variant(), theta));
                steps.add(seed.guess().steps().get(i));
            }
        }
        double[] by = steps.stream().mapToDouble(Double::doubleValue).toArray();
        List<List<WindowDerivatives>> derivatives = base.derivatives(moved, by);
        int longest = base.longest();
        List<List<Seed>> kept = new ArrayList<>();
        List<Fit> fits = new ArrayList<>();
        for (int perBlock :
                new int[] {Math.max(1, longest / 32), Math.max(1, longest / 8), longest}) {
            List<List<WindowBlock>> blocks = base.blocks(derivatives, perBlock);
            Gram gram = new Gram(blocks, moved.size());
            for (int size = 1; size <= 2; size++) {
                for (List<Seed> set : best(gram, sets(size))) {
                    if (!kept.contains(set)) {
                        kept.add(set);
                        fits.add(begun(base, blocks, gram, set, moved.size()));
                    }
                }
            }
        }
        return fits;
    }

    /** A set of causes with the numbers that the linearised runs ask for. */
    private Fit begun(
            Fit base, List<List<WindowBlock>> blocks, Gram gram, List<Seed> set, int columns) {
        int[] of = columns(set);
        double[] solved = gram.solve(of);
        double[] change = new double[columns];
        List<double[]> theta = new ArrayList<>();
        int i = 0;
        for (Seed seed : set) {
            double[] numbers =
                    seed.guess().theta().stream().mapToDouble(Double::doubleValue).toArray();
            for (int c : seed.guess().columns()) {
                numbers[c] = seed.cause().parameters().get(c).clipped(solved[i]);
                change[of[i]] = solved[i];
                i++;
            }
            theta.add(numbers);
        }
        Fit moved = Refinement.moved(base, blocks, change, Hypothesis.NONE, 1);
        return moved.with(
                new Hypothesis(set.stream().map(Seed::cause).toList(), theta), moved.windows());
    }

    private static int[] columns(List<Seed> set) {
        return set.stream().flatMapToInt(seed -> java.util.Arrays.stream(seed.columns())).toArray();
    }

    private List<List<Seed>> sets(int size) {
        List<List<Seed>> sets = new ArrayList<>();
        for (int i = 0; i < seeds.size(); i++) {
            if (size == 1) {
                sets.add(List.of(seeds.get(i)));
            }
            for (int j = i + 1; size == 2 && j < seeds.size(); j++) {
                if (seeds.get(i).cause() != seeds.get(j).cause()) {
                    sets.add(List.of(seeds.get(i), seeds.get(j)));
                }
            }
        }
        return sets;
    }

    private List<List<Seed>> best(Gram gram, List<List<Seed>> sets) {
        record Promise(List<Seed> set, double score) {}
        double perParameter = Math.log(count);
        return sets.stream()
                .map(
                        set -> {
                            int[] of = columns(set);
                            double drop = gram.drop(of, gram.solve(of));
                            return new Promise(set, drop - perParameter * of.length);
                        })
                .sorted(Comparator.comparingDouble(Promise::score).reversed())
                .limit(KEPT)
                .map(Promise::set)
                .toList();
    }
}
