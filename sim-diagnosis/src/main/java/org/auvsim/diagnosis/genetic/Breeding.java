package org.auvsim.diagnosis.genetic;

import org.apache.commons.math3.genetics.Chromosome;
import org.apache.commons.math3.genetics.ChromosomePair;
import org.apache.commons.math3.genetics.CrossoverPolicy;
import org.apache.commons.math3.genetics.ElitisticListPopulation;
import org.apache.commons.math3.genetics.GeneticAlgorithm;
import org.apache.commons.math3.genetics.ListPopulation;
import org.apache.commons.math3.genetics.MutationPolicy;
import org.apache.commons.math3.genetics.Population;
import org.apache.commons.math3.genetics.SelectionPolicy;
import org.apache.commons.math3.random.RandomGenerator;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * A genetic algorithm whose lots are all drawn from one generator of its own, so that a seed
 * repeats it, and which judges a generation as a whole, side by side, before anybody asks for its
 * fitness.
 */
final class Breeding extends GeneticAlgorithm {
    private static final double CROSSOVER_RATE = 0.5;
    private static final double MUTATION_RATE = 0.9;
    private static final double ELITE = 0.2;
    private static final int RIVALS = 3;

    private final RandomGenerator lot;
    private final Consumer<List<Chromosome>> judge;

    /**
     * By these policies.
     *
     * @param judge gives each of a generation its fitness
     */
    Breeding(
            CrossoverPolicy crossover,
            MutationPolicy mutation,
            RandomGenerator lot,
            Consumer<List<Chromosome>> judge) {
        super(crossover, CROSSOVER_RATE, mutation, MUTATION_RATE, tournament(lot));
        this.lot = lot;
        this.judge = judge;
    }

    /** The best of a few drawn by lot, twice. */
    private static SelectionPolicy tournament(RandomGenerator lot) {
        return population -> {
            List<Chromosome> all = ((ListPopulation) population).getChromosomes();
            return new ChromosomePair(winner(all, lot), winner(all, lot));
        };
    }

    private static Chromosome winner(List<Chromosome> all, RandomGenerator lot) {
        Chromosome winner = all.get(lot.nextInt(all.size()));
        for (int i = 1; i < RIVALS; i++) {
            Chromosome rival = all.get(lot.nextInt(all.size()));
            winner = rival.getFitness() > winner.getFitness() ? rival : winner;
        }
        return winner;
    }

    /** The first generation, judged. */
    Population first(List<Chromosome> chromosomes) {
        judge.accept(chromosomes);
        return new ElitisticListPopulation(chromosomes, chromosomes.size(), ELITE);
    }

    @Override
    public Population nextGeneration(Population current) {
        Population next = current.nextGeneration();
        List<Chromosome> born = new ArrayList<>();
        while (next.getPopulationSize() + born.size() < next.getPopulationLimit()) {
            ChromosomePair pair = getSelectionPolicy().select(current);
            if (lot.nextDouble() < getCrossoverRate()) {
                pair = getCrossoverPolicy().crossover(pair.getFirst(), pair.getSecond());
            }
            born.add(perhapsMutated(pair.getFirst()));
            if (next.getPopulationSize() + born.size() < next.getPopulationLimit()) {
                born.add(perhapsMutated(pair.getSecond()));
            }
        }
        judge.accept(born);
        born.forEach(next::addChromosome);
        return next;
    }

    private Chromosome perhapsMutated(Chromosome of) {
        return lot.nextDouble() < getMutationRate() ? getMutationPolicy().mutate(of) : of;
    }
}
