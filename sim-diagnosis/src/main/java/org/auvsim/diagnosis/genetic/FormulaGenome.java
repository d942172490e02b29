package org.auvsim.diagnosis.genetic;

import org.apache.commons.math3.genetics.Chromosome;

/** A formula as a chromosome. */
final class FormulaGenome extends Chromosome {
    private final Expression expression;
    private double fitness = Double.NaN;

    FormulaGenome(Expression expression) {
        this.expression = expression;
    }

    Expression expression() {
        return expression;
    }

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
