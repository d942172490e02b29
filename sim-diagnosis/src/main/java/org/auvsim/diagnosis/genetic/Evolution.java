package org.auvsim.diagnosis.genetic;

import org.apache.commons.math3.genetics.Chromosome;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.search.Arena;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Evolves sets of causes and their numbers: a population of models, slightly permuted from the
 * believed one, is simulated side by side through measured runs, and those that miss least have
 * offspring (thesis, section 9.4; Holland 1975). The same seed gives the same models.
 *
 * @param seed of all that is drawn by lot
 */
public record Evolution(long seed) implements Arena.Contest {
    private static final int LEAST_POPULATION = 64;

    /** So many models are simulated at most, and so many samples of all of them together. */
    private static final int MOST_MODELS = 3000;

    private static final long MOST_SAMPLES = 5_000_000;

    private static final int MOST_CANDIDATES = 16;

    @Override
    public List<Arena.Candidate> candidates(Arena arena, List<Cause> causes) {
        if (causes.isEmpty()) {
            return List.of();
        }
        RandomGenerator lot = new Well19937c(seed);
        Heredity heredity = new Heredity(causes, arena.runs(), lot);
        Map<Set<Cause>, ModelGenome> best = new LinkedHashMap<>();
        Breeding breeding = new Breeding(heredity, heredity, lot, born -> judge(arena, born, best));
        List<Chromosome> first = first(heredity, causes.size());
        int models = (int) Math.min(MOST_MODELS, MOST_SAMPLES / arena.samples());
        int generations = Math.max(1, models / first.size());
        breeding.evolve(
                breeding.first(first),
                _ ->
                        breeding.getGenerationsEvolved() >= generations
                                || !arena.goesOn(
                                        (double) breeding.getGenerationsEvolved() / generations));
        return best.values().stream()
                .filter(genome -> !genome.genes().isEmpty())
                .sorted(Comparator.comparingDouble(ModelGenome::fitness).reversed())
                .limit(MOST_CANDIDATES)
                .map(ModelGenome::candidate)
                .toList();
    }

    /** The believed model, and it with each of the causes, several times. */
    private static List<Chromosome> first(Heredity heredity, int causes) {
        List<Chromosome> first = new ArrayList<>();
        first.add(new ModelGenome(List.of()));
        do {
            for (int cause = 0; cause < causes; cause++) {
                first.add(new ModelGenome(List.of(heredity.gene(cause))));
            }
        } while (first.size() < LEAST_POPULATION);
        return first;
    }

    /** Gives fitness to those that have none, and keeps the best of each set of causes. */
    private static void judge(
            Arena arena, List<Chromosome> born, Map<Set<Cause>, ModelGenome> best) {
        List<ModelGenome> genomes =
                born.stream()
                        .map(ModelGenome.class::cast)
                        .filter(genome -> !genome.isJudged())
                        .distinct()
                        .toList();
        Variant believed = arena.model().variant();
        List<Variant> variants = genomes.stream().map(g -> g.candidate().in(believed)).toList();
        double[] misfits = arena.misfits(variants);
        for (int i = 0; i < misfits.length; i++) {
            ModelGenome genome = genomes.get(i);
            genome.judge(fitness(arena, genome, misfits[i]));
            best.merge(
                    genome.causes(),
                    genome,
                    (old, now) -> now.fitness() > old.fitness() ? now : old);
        }
    }

    /** Schwarz's criterion (1978), and a surcharge for each cause; the larger, the better. */
    private static double fitness(Arena arena, ModelGenome genome, double misfit) {
        int count = arena.count();
        double deviance = count * StrictMath.log(Math.max(misfit / count, Double.MIN_NORMAL));
        return -(deviance + arena.price(genome.candidate()));
    }
}
