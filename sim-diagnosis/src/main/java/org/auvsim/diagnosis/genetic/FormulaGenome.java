package org.auvsim.diagnosis.genetic;

/** A formula as a chromosome. */
final class FormulaGenome extends Genome {
    private final Expression expression;

    FormulaGenome(Expression expression) {
        this.expression = expression;
    }

    Expression expression() {
        return expression;
    }
}
