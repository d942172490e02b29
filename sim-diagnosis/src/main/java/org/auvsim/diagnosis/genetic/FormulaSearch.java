package org.auvsim.diagnosis.genetic;

import org.apache.commons.math3.genetics.Chromosome;
import org.apache.commons.math3.random.Well19937c;
import org.auvsim.diagnosis.genetic.Formula.Sample;
import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.result.Proposal;
import org.auvsim.diagnosis.verdict.ImitationTrial;
import org.auvsim.diagnosis.verdict.Imitator;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

/**
 * Searches a formula for the force that a model lacks, where no known cause explains it: by small
 * expression trees that compete and have offspring (Koza 1992). What it finds imitates the force;
 * it is not its cause. The same seed gives the same formula.
 */
public final class FormulaSearch implements Imitator {
    private static final int POPULATION = 300;
    private static final int GENERATIONS = 60;

    /** A formula must imitate such a share of the variance of forces that it was not made for. */
    private static final double LEAST_SHARE = 0.5;

    /** The error on held-out runs must fall to this share: less is no help. */
    private static final double MOST_LEFT = 0.8;

    /** What a node must gain, in logarithms of the variance that is left. */
    private static final double PER_NODE = 0.02;

    /** No more of the variance can be imitated than this: the rest is rounding. */
    private static final double ROUNDED = 1e-9;

    private static final int FEWEST = 8;
    private static final String AXES = "xyz";

    private final long seed;

    /** With what is drawn by lot from a seed. */
    public FormulaSearch(long seed) {
        this.seed = seed;
    }

    @Override
    public Optional<Proposal> proposal(Diagnosis diagnosis, ImitationTrial trial) {
        List<Optional<Formula>> axes = new ArrayList<>();
        for (int axis = 0; axis < AXES.length(); axis++) {
            axes.add(along(axis, diagnosis.runs(), trial::goesOn));
        }
        return trial.goesOn() && axes.stream().anyMatch(Optional::isPresent)
                ? gain(axes, trial)
                        .filter(gain -> gain.after() < MOST_LEFT * gain.before())
                        .map(gain -> new Proposal("formula", text(axes), gain))
                : Optional.empty();
    }

    private static String text(List<Optional<Formula>> axes) {
        List<String> parts = new ArrayList<>();
        for (int axis = 0; axis < axes.size(); axis++) {
            char name = AXES.charAt(axis);
            axes.get(axis)
                    .ifPresent(
                            formula ->
                                    parts.add(
                                            String.format(
                                                    Locale.ROOT,
                                                    "F.%c = %s",
                                                    name,
                                                    formula.text())));
        }
        return String.join("; ", parts) + " (N, world)";
    }

    private Optional<Formula> along(int axis, List<DiagnosedRun> runs, BooleanSupplier goesOn) {
        List<Sample> made = samples(axis, runs, false);
        List<Sample> heldOut = samples(axis, runs, true);
        if (made.size() < FEWEST || heldOut.size() < FEWEST) {
            return Optional.empty();
        }
        return Optional.of(found(made, goesOn)).filter(f -> f.shareOf(heldOut) >= LEAST_SHARE);
    }

    private static List<Sample> samples(int axis, List<DiagnosedRun> runs, boolean heldOut) {
        return runs.stream()
                .filter(run -> run.isHeldOut() == heldOut)
                .flatMap(run -> MissingForces.along(run, axis).stream())
                .toList();
    }

    /** The formula that imitates forces best for its size; of those so far once it is stopped. */
    Formula found(List<Sample> samples, BooleanSupplier goesOn) {
        Well19937c lot = new Well19937c(seed);
        FormulaHeredity heredity = new FormulaHeredity(varying(samples), lot);
        Breeding breeding =
                new Breeding(
                        heredity, heredity, lot, born -> born.forEach(one -> judge(one, samples)));
        List<Chromosome> first = new ArrayList<>();
        for (int i = 0; i < POPULATION; i++) {
            first.add(heredity.any());
        }
        FormulaGenome best =
                (FormulaGenome)
                        breeding.evolve(
                                        breeding.first(first),
                                        _ ->
                                                breeding.getGenerationsEvolved() >= GENERATIONS
                                                        || !goesOn.getAsBoolean())
                                .getFittestChromosome();
        return Formula.scaled(best.expression(), samples);
    }

    /** What never changes explains nothing. */
    private static List<Integer> varying(List<Sample> samples) {
        double[] first = samples.getFirst().variables();
        return IntStream.range(0, first.length)
                .filter(v -> samples.stream().anyMatch(s -> s.variables()[v] != first[v]))
                .boxed()
                .toList();
    }

    private static void judge(Chromosome one, List<Sample> samples) {
        FormulaGenome genome = (FormulaGenome) one;
        if (!genome.isJudged()) {
            double left = 1 - Formula.scaled(genome.expression(), samples).share();
            genome.judge(
                    -StrictMath.log(Math.max(left, ROUNDED))
                            - PER_NODE * genome.expression().size());
        }
    }

    /** On held-out runs, of the position. */
    private static Optional<Gain> gain(List<Optional<Formula>> axes, ImitationTrial trial) {
        FormulaForce force = new FormulaForce(axes);
        return trial.positionGain(variant -> variant.with(body -> body.effect(force)));
    }
}
