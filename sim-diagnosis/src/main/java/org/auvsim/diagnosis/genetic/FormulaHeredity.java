package org.auvsim.diagnosis.genetic;

import org.apache.commons.math3.genetics.Chromosome;
import org.apache.commons.math3.genetics.ChromosomePair;
import org.apache.commons.math3.genetics.CrossoverPolicy;
import org.apache.commons.math3.genetics.MutationPolicy;
import org.apache.commons.math3.random.RandomGenerator;
import org.auvsim.diagnosis.genetic.Expression.Constant;
import org.auvsim.diagnosis.genetic.Expression.Operation;
import org.auvsim.diagnosis.genetic.Expression.Variable;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

/** How formulas inherit: children exchange branches (Koza 1992), mutants change one. */
final class FormulaHeredity implements CrossoverPolicy, MutationPolicy {
    private static final int DEEPEST = 3;
    private static final int LARGEST = 15;
    private static final List<Operator> OPERATORS = List.of(Operator.values());

    private final List<Integer> variables;
    private final RandomGenerator lot;

    /**
     * Of formulas.
     *
     * @param variables indices of those that may occur
     */
    FormulaHeredity(List<Integer> variables, RandomGenerator lot) {
        this.variables = variables;
        this.lot = lot;
    }

    FormulaGenome any() {
        return new FormulaGenome(any(DEEPEST));
    }

    private Expression any(int depth) {
        if (depth == 0 || lot.nextDouble() < 0.3) {
            return lot.nextDouble() < 0.7
                    ? new Variable(variables.get(lot.nextInt(variables.size())))
                    : new Constant(StrictMath.pow(10, 2 * lot.nextDouble() - 1));
        }
        Operator operator = OPERATORS.get(lot.nextInt(OPERATORS.size()));
        List<Expression> parts = new ArrayList<>();
        parts.add(any(depth - 1));
        if (!operator.isUnary()) {
            parts.add(any(depth - 1));
        }
        return new Operation(operator, List.copyOf(parts));
    }

    @Override
    public ChromosomePair crossover(Chromosome first, Chromosome second) {
        Expression one = ((FormulaGenome) first).expression();
        Expression other = ((FormulaGenome) second).expression();
        Expression fromOne = branch(one, lot.nextInt(one.size()));
        Expression fromOther = branch(other, lot.nextInt(other.size()));
        return new ChromosomePair(
                child(one, changed(one, lot.nextInt(one.size()), _ -> fromOther)),
                child(other, changed(other, lot.nextInt(other.size()), _ -> fromOne)));
    }

    @Override
    public Chromosome mutate(Chromosome original) {
        Expression of = ((FormulaGenome) original).expression();
        return child(of, changed(of, lot.nextInt(of.size()), this::mutated));
    }

    private Expression mutated(Expression branch) {
        return branch instanceof Constant(double value) && lot.nextDouble() < 0.8
                ? new Constant(
                        value
                                * (1
                                        + StrictMath.pow(10, -3 * lot.nextDouble())
                                                * lot.nextGaussian()))
                : any(DEEPEST - 1);
    }

    private static FormulaGenome child(Expression parent, Expression child) {
        return new FormulaGenome(child.size() <= LARGEST ? child : parent);
    }

    /** The branch at a node, counted from the root on. */
    private static Expression branch(Expression of, int node) {
        if (node == 0) {
            return of;
        }
        int left = node - 1;
        for (Expression part : of.parts()) {
            if (left < part.size()) {
                return branch(part, left);
            }
            left -= part.size();
        }
        throw new IllegalArgumentException("no node " + node + " in " + of.text());
    }

    /** The same with another branch at a node. */
    private static Expression changed(Expression of, int node, UnaryOperator<Expression> change) {
        if (node == 0) {
            return change.apply(of);
        }
        int left = node - 1;
        List<Expression> parts = new ArrayList<>();
        for (Expression part : of.parts()) {
            parts.add(left >= 0 && left < part.size() ? changed(part, left, change) : part);
            left -= part.size();
        }
        return of.of(parts);
    }
}
