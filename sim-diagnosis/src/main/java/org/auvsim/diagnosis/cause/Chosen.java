package org.auvsim.diagnosis.cause;

import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.List;
import java.util.Optional;

/**
 * One of a few causes that alone are looked for. Of many causes one gains much by chance more often
 * than of few, so that it must gain more for the same rate of false alarms (Bonferroni). Where
 * errors last many causes imitate them, few do not: for these only independent numbers count.
 *
 * @param less what it must gain less than one of the whole library
 */
record Chosen(Cause cause, double less) implements Cause {
    /** Of some causes out of a whole library. */
    static List<Cause> of(List<Cause> some, List<Cause> library) {
        double less = 2 * StrictMath.log((double) library.size() / some.size());
        return some.stream()
                .<Cause>map(cause -> new Chosen(cause, Math.min(less, cause.price())))
                .toList();
    }

    @Override
    public String id() {
        return cause.id();
    }

    @Override
    public Optional<String> subject() {
        return cause.subject();
    }

    @Override
    public String label() {
        return cause.label();
    }

    @Override
    public List<Parameter> parameters() {
        return cause.parameters();
    }

    @Override
    public Variant in(Variant model, double[] theta) {
        return cause.in(model, theta);
    }

    @Override
    public List<Guess> guesses(List<MeasuredRun> runs) {
        return cause.guesses(runs);
    }

    @Override
    public List<Guess> aliases(double[] theta) {
        return cause.aliases(theta);
    }

    @Override
    public List<Quantity> quantities(double[] theta) {
        return cause.quantities(theta);
    }

    @Override
    public double price() {
        return cause.price() - less;
    }

    @Override
    public double price(int measured, double independent) {
        int counted = (int) Math.max(1, Math.round(independent));
        return cause.price(counted, independent) - less;
    }

    @Override
    public Optional<Cause> freer() {
        return cause.freer().map(freer -> new Chosen(freer, less));
    }

    @Override
    public boolean isGeneric() {
        return cause.isGeneric();
    }

    @Override
    public String toString() {
        return cause.toString();
    }
}
