package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.WindowDerivatives.Column;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/** Looks for the causes that explain what a model misses of measured runs. */
public final class Search {
    private static final int KEPT = 5;
    private static final double PER_CAUSE = 12;

    private final BelievedModel model;
    private final List<MeasuredRun> runs;
    private final List<Cause> library;
    private final Weights weights;

    /** What one set of causes makes of the runs; the smaller the score, the better. */
    public record Candidate(List<String> causes, List<double[]> theta, double cost, double score) {}

    record Scored(Fit fit, double cost, double score) {}

    public Search(BelievedModel model, List<MeasuredRun> runs, List<Cause> library) {
        this.model = model;
        this.runs = runs;
        this.library = library;
        this.weights = Noise.of(runs);
    }

    /** Sets of causes, the best first. */
    public List<Candidate> candidates() {
        Fit base =
                new Fit(
                        model,
                        runs,
                        weights,
                        List.of(),
                        List.of(),
                        Following.of(model, model.variant(), runs, weights));
        List<Scored> scored = new ArrayList<>();
        scored.add(scored(Refinement.refine(base, 1)));
        for (List<Cause> set : screen(base)) {
            Fit start =
                    new Fit(
                            model,
                            runs,
                            weights,
                            set,
                            set.stream().map(c -> new double[c.parameters().size()]).toList(),
                            base.windows());
            scored.add(scored(Refinement.refine(start, 1)));
        }
        scored.sort(Comparator.comparingDouble(Scored::score));
        return scored.stream()
                .map(
                        s ->
                                new Candidate(
                                        s.fit().causes().stream().map(Cause::id).toList(),
                                        s.fit().theta(),
                                        s.cost(),
                                        s.score()))
                .toList();
    }

    private Scored scored(Fit fit) {
        double cost = fit.cost();
        long rows = samples() * (runs.getFirst().hasOrientation() ? 6 : 3);
        int k = fit.columns().size();
        double score =
                rows * Math.log(cost / rows)
                        + k * Math.log(rows)
                        + PER_CAUSE * fit.causes().size();
        return new Scored(fit, cost, score);
    }

    private long samples() {
        return runs.stream().mapToLong(MeasuredRun::size).sum();
    }

    /** The singles and pairs that promise most, by the linearised runs. */
    private List<List<Cause>> screen(Fit base) {
        List<Column> columns = Fit.columns(library);
        List<List<WindowDerivatives>> derivatives = base.derivatives(columns);
        int longest = base.windows().stream().mapToInt(List::size).max().orElse(1);
        List<List<Cause>> kept = new ArrayList<>();
        for (int perBlock : new int[] {Math.max(1, longest / 32), Math.max(1, longest / 8), longest}) {
            Gram gram = new Gram(Fit.blocks(runs, derivatives, perBlock), columns.size());
            keepBest(gram, columns, sets(1), kept);
            keepBest(gram, columns, sets(2), kept);
        }
        return kept;
    }

    private List<List<Cause>> sets(int size) {
        List<List<Cause>> sets = new ArrayList<>();
        for (int i = 0; i < library.size(); i++) {
            if (size == 1) {
                sets.add(List.of(library.get(i)));
            }
            for (int j = i + 1; size == 2 && j < library.size(); j++) {
                sets.add(List.of(library.get(i), library.get(j)));
            }
        }
        return sets;
    }

    private void keepBest(
            Gram gram, List<Column> columns, List<List<Cause>> sets, List<List<Cause>> kept) {
        record Promise(List<Cause> set, double score) {}
        double perParameter = Math.log(3.0 * samples());
        sets.stream()
                .map(
                        set -> {
                            int[] of =
                                    IntStream.range(0, columns.size())
                                            .filter(c -> set.contains(columns.get(c).cause()))
                                            .toArray();
                            double drop = gram.drop(of, gram.solve(of));
                            return new Promise(set, drop - perParameter * of.length);
                        })
                .sorted(Comparator.comparingDouble(Promise::score).reversed())
                .limit(KEPT)
                .map(Promise::set)
                .filter(set -> !kept.contains(set))
                .forEach(kept::add);
    }
}
