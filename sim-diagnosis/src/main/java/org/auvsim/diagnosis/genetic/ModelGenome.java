package org.auvsim.diagnosis.genetic;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.search.Arena;

import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/** A model as a chromosome: which causes are active, and their numbers. */
final class ModelGenome extends Genome {
    /** An active cause, and a number for each of its parameters. */
    static final class Gene {
        private final Cause cause;
        private final double[] theta;

        Gene(Cause cause, double[] theta) {
            this.cause = cause;
            this.theta = theta;
        }

        Cause cause() {
            return cause;
        }

        /** Not to be changed. */
        double[] theta() {
            return theta;
        }
    }

    private final List<Gene> genes;

    /** Of these genes, each of another cause; their order means nothing. */
    ModelGenome(List<Gene> genes) {
        this.genes =
                genes.stream().sorted(Comparator.comparing(gene -> gene.cause().label())).toList();
    }

    List<Gene> genes() {
        return genes;
    }

    Set<Cause> causes() {
        return genes.stream().map(Gene::cause).collect(Collectors.toUnmodifiableSet());
    }

    Arena.Candidate candidate() {
        return new Arena.Candidate(
                genes.stream().map(Gene::cause).toList(), genes.stream().map(Gene::theta).toList());
    }
}
