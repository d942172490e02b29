package org.auvsim.diagnosis.genetic;

import org.apache.commons.math3.genetics.Chromosome;

/** A chromosome that is judged with others of its generation; its fitness is NaN before. */
abstract class Genome extends Chromosome {
    private double fitness = Double.NaN;

    boolean isJudged() {
        return !Double.isNaN(fitness);
    }

    void judge(double found) {
        fitness = found;
    }

    @Override
    public double fitness() {
        return fitness;
    }
}
