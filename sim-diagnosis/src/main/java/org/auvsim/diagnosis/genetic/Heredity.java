package org.auvsim.diagnosis.genetic;

import org.apache.commons.math3.genetics.Chromosome;
import org.apache.commons.math3.genetics.ChromosomePair;
import org.apache.commons.math3.genetics.CrossoverPolicy;
import org.apache.commons.math3.genetics.MutationPolicy;
import org.apache.commons.math3.random.RandomGenerator;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Guess;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.genetic.ModelGenome.Gene;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** How models inherit: children share out their parents' causes, mutants change them. */
final class Heredity implements CrossoverPolicy, MutationPolicy {
    private static final int MOST_GENES = 3;

    /** Powers of ten of a parameter's scale by which numbers change. */
    private static final double SMALLEST = -2;

    private static final double LARGEST = 1;

    private final List<Cause> causes;
    private final List<List<Guess>> guesses;
    private final RandomGenerator lot;

    Heredity(List<Cause> causes, List<MeasuredRun> runs, RandomGenerator lot) {
        this.causes = causes;
        this.guesses = causes.stream().map(cause -> cause.guesses(runs)).toList();
        this.lot = lot;
    }

    /** A gene of one of the causes, with numbers drawn by lot around one of its guesses. */
    Gene gene(int cause) {
        Cause of = causes.get(cause);
        List<Guess> all = guesses.get(cause);
        Guess guess = all.get(lot.nextInt(all.size()));
        double[] theta = guess.theta().stream().mapToDouble(Double::doubleValue).toArray();
        for (int column : guess.columns()) {
            theta[column] = moved(of.parameters().get(column), theta[column]);
        }
        return new Gene(of, theta);
    }

    private double moved(Parameter parameter, double number) {
        double power = SMALLEST + (LARGEST - SMALLEST) * lot.nextDouble();
        double step = parameter.scale() * StrictMath.pow(10, power) * lot.nextGaussian();
        double moved = number + step;
        double inside = moved < parameter.lowest() ? number - step : moved;
        return parameter.clipped(inside);
    }

    @Override
    public ChromosomePair crossover(Chromosome first, Chromosome second) {
        Map<Cause, Gene> one = new LinkedHashMap<>();
        Map<Cause, Gene> other = new LinkedHashMap<>();
        share(((ModelGenome) first).genes(), one, other);
        share(((ModelGenome) second).genes(), other, one);
        return new ChromosomePair(child(one), child(other));
    }

    private void share(List<Gene> genes, Map<Cause, Gene> one, Map<Cause, Gene> other) {
        for (Gene gene : genes) {
            boolean isForOne = lot.nextBoolean();
            Map<Cause, Gene> to = isForOne ? one : other;
            Map<Cause, Gene> instead = isForOne ? other : one;
            if (to.putIfAbsent(gene.cause(), gene) != null) {
                instead.putIfAbsent(gene.cause(), gene);
            }
        }
    }

    private static ModelGenome child(Map<Cause, Gene> genes) {
        return new ModelGenome(genes.values().stream().limit(MOST_GENES).toList());
    }

    @Override
    public Chromosome mutate(Chromosome original) {
        List<Gene> genes = new ArrayList<>(((ModelGenome) original).genes());
        double choice = lot.nextDouble();
        if (genes.isEmpty() || (choice < 0.15 && genes.size() < MOST_GENES)) {
            add(genes);
        } else if (choice < 0.25) {
            genes.remove(lot.nextInt(genes.size()));
        } else if (choice < 0.35) {
            genes.remove(lot.nextInt(genes.size()));
            add(genes);
        } else {
            genes.replaceAll(this::moved);
        }
        return new ModelGenome(genes);
    }

    private void add(List<Gene> genes) {
        Gene more = gene(lot.nextInt(causes.size()));
        if (genes.stream().noneMatch(gene -> gene.cause().equals(more.cause()))) {
            genes.add(more);
        }
    }

    /** One of its numbers, or all. */
    private Gene moved(Gene gene) {
        double[] theta = gene.theta().clone();
        if (theta.length == 0) {
            return gene;
        }
        int only = lot.nextBoolean() ? lot.nextInt(theta.length) : -1;
        for (int i = 0; i < theta.length; i++) {
            if (only < 0 || only == i) {
                theta[i] = moved(gene.cause().parameters().get(i), theta[i]);
            }
        }
        return new Gene(gene.cause(), theta);
    }
}
