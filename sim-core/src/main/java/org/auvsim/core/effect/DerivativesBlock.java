package org.auvsim.core.effect;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Effect;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The hydrodynamic derivatives of all bodies of a world: one column of coefficients for each form
 * of term that some body has. A block without any is passed over.
 */
final class DerivativesBlock implements BlockEffect {
    /** A form of term and its coefficients by slot; 0 where a body has none. */
    private static final class Term {
        final Derivative.Form form;
        final double[] coefficients;

        Term(Derivative.Form form, int slots) {
            this.form = form;
            coefficients = new double[slots];
        }
    }

    private final List<Term> terms = new ArrayList<>();
    private final boolean[] has;

    DerivativesBlock(List<List<Effect>> bySlot) {
        has = new boolean[bySlot.size()];
        for (int slot = 0; slot < has.length; slot++) {
            for (Effect effect : bySlot.get(slot)) {
                HydrodynamicDerivatives derivatives = (HydrodynamicDerivatives) effect;
                for (Derivative derivative : derivatives.derivative()) {
                    Derivative.Form form = derivative.form();
                    column(form)[slot] += form.signIn(derivatives.axes()) * derivative.value();
                    has[slot] = true;
                }
            }
        }
    }

    private double[] column(Derivative.Form form) {
        for (Term term : terms) {
            if (term.form.equals(form)) {
                return term.coefficients;
            }
        }
        terms.add(new Term(form, has.length));
        return terms.getLast().coefficients;
    }

    @Override
    public void add(Block b) {
        if (!ThroughWater.isAnyOf(b, has)) {
            return;
        }
        for (int axis = 0; axis < ThroughWater.AXES; axis++) {
            Arrays.fill(b.scratch[axis], 0, b.count, 0);
        }
        for (int t = 0; t < terms.size(); t++) {
            add(b, terms.get(t));
        }
        ThroughWater.push(b);
    }

    private static void add(Block b, Term term) {
        double[] k = b.scratch[ThroughWater.FREE];
        b.gather(term.coefficients, k);
        double[] force = b.scratch[term.form.force()];
        double[] first = ThroughWater.velocity(b, term.form.first());
        double[] second = ThroughWater.velocity(b, term.form.second());
        switch (term.form.kind()) {
            case NONE -> addLinear(b.count, force, k, first);
            case SIGNED -> addProduct(b.count, force, k, first, second);
            case SIZE -> addBySize(b.count, force, k, first, second);
        }
    }

    private static void addLinear(int count, double[] force, double[] k, double[] v) {
        for (int i = 0; i < count; i++) {
            force[i] += k[i] * v[i];
        }
    }

    private static void addProduct(
            int count, double[] force, double[] k, double[] v, double[] other) {
        for (int i = 0; i < count; i++) {
            force[i] += k[i] * v[i] * other[i];
        }
    }

    private static void addBySize(
            int count, double[] force, double[] k, double[] v, double[] other) {
        for (int i = 0; i < count; i++) {
            force[i] += k[i] * v[i] * Math.abs(other[i]);
        }
    }
}
