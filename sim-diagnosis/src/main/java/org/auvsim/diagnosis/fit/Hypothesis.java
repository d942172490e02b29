package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.WindowDerivatives.Moves;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.UnaryOperator;

/**
 * Causes, and the numbers that each has.
 *
 * @param theta for each cause a number for each of its parameters
 */
public record Hypothesis(List<Cause> causes, List<double[]> theta) {
    /** That the model lacks nothing. */
    public static final Hypothesis NONE = new Hypothesis(List.of(), List.of());

    /** Causes whose numbers are not to be moved any more. */
    private record Settled(Hypothesis hypothesis) implements Cause {
        @Override
        public String id() {
            return "settled";
        }

        @Override
        public List<Parameter> parameters() {
            return List.of();
        }

        @Override
        public Variant in(Variant model, double[] theta) {
            return hypothesis.in(model);
        }
    }

    /** The same, its numbers not to be moved. */
    public Hypothesis settled() {
        return new Hypothesis(List.of(new Settled(this)), List.of(new double[0]));
    }

    /** A parameter of one of the causes. */
    private record Place(int cause, int parameter) {}

    private List<Place> places() {
        List<Place> places = new ArrayList<>();
        for (int c = 0; c < causes.size(); c++) {
            for (int p = 0; p < theta.get(c).length; p++) {
                places.add(new Place(c, p));
            }
        }
        return places;
    }

    /** Whether one of the causes is one that can imitate others. */
    public boolean isGeneric() {
        return causes.stream().anyMatch(Cause::isGeneric);
    }

    /** Whether both have the same causes, in whatever order. */
    public boolean hasCausesOf(Hypothesis other) {
        return causes.size() == other.causes.size() && causes.containsAll(other.causes);
    }

    /** Number of parameters of all causes. */
    public int size() {
        return theta.stream().mapToInt(t -> t.length).sum();
    }

    /** How many of them can be more than one number. */
    int free() {
        return (int) parameters().stream().filter(Parameter::isFree).count();
    }

    /** What all causes must gain to be believed, beside what their parameters must. */
    public double price() {
        return causes.stream().mapToDouble(Cause::price).sum();
    }

    /** What they must gain in all, as {@link Cause#price(int, double)}. */
    public double price(int measured, double independent) {
        return causes.stream().mapToDouble(cause -> cause.price(measured, independent)).sum();
    }

    /** Parameters of all causes in a row. */
    public List<Parameter> parameters() {
        return causes.stream().flatMap(cause -> cause.parameters().stream()).toList();
    }

    /** The model with the causes. */
    public Variant in(Variant model) {
        Variant variant = model;
        for (int c = 0; c < causes.size(); c++) {
            variant = causes.get(c).in(variant, theta.get(c));
        }
        return variant;
    }

    /**
     * The model with the causes, one parameter moved by a small step in each, within its bounds.
     */
    public Moves moves(Variant model) {
        return moves(model, steps());
    }

    /** Small steps of all parameters. */
    double[] steps() {
        return parameters().stream().mapToDouble(of -> Cause.SMALL * of.scale()).toArray();
    }

    /** The model with the causes, one parameter moved in each by its step, within its bounds. */
    Moves moves(Variant model, double[] by) {
        double[] numbers = numbers();
        List<Parameter> parameters = parameters();
        List<Double> steps = new ArrayList<>();
        List<Variant> moved = new ArrayList<>();
        for (int i = 0; i < numbers.length; i++) {
            Parameter parameter = parameters.get(i);
            double step = by[i];
            double[] change = new double[numbers.length];
            change[i] = numbers[i] + step > parameter.highest() ? -step : step;
            steps.add(change[i]);
            moved.add(plus(change, UnaryOperator.identity()).in(model));
        }
        return new Moves(moved, steps);
    }

    /** The numbers of all causes in a row. */
    public double[] numbers() {
        return theta.stream().flatMapToDouble(Arrays::stream).toArray();
    }

    /** How far they may be moved. */
    Bounds bounds() {
        return Bounds.of(parameters(), numbers());
    }

    /** The same with one more cause. */
    public Hypothesis and(Cause cause, double[] numbers) {
        List<Cause> more = new ArrayList<>(causes);
        more.add(cause);
        List<double[]> all = new ArrayList<>(theta);
        all.add(numbers);
        return new Hypothesis(more, all);
    }

    /** The same without one of the causes. */
    public Hypothesis without(int cause) {
        List<Cause> fewer = new ArrayList<>(causes);
        fewer.remove(cause);
        List<double[]> left = new ArrayList<>(theta);
        left.remove(cause);
        return new Hypothesis(fewer, left);
    }

    /** The same with another cause in place of one, its numbers kept. */
    public Hypothesis with(int place, Cause cause) {
        List<Cause> others = new ArrayList<>(causes);
        others.set(place, cause);
        return new Hypothesis(others, theta);
    }

    /** The same with a freer form of one cause, begun at each of its guesses at runs. */
    public List<Hypothesis> freed(int place, List<MeasuredRun> runs) {
        return causes.get(place).freer().stream()
                .flatMap(
                        freer ->
                                freer.guesses(runs).stream()
                                        .map(guess -> with(place, freer, guess.theta())))
                .toList();
    }

    /** The numbers of a cause, and those that a guess at another one adds to them. */
    private Hypothesis with(int place, Cause other, List<Double> guess) {
        double[] begun = guess.stream().mapToDouble(number -> number).toArray();
        double[] own = theta.get(place);
        System.arraycopy(own, 0, begun, 0, own.length);
        List<double[]> others = new ArrayList<>(theta);
        others.set(place, begun);
        return new Hypothesis(with(place, other).causes, others);
    }

    /** Whether each cause has as many numbers as parameters, all within their bounds. */
    public boolean makesSense() {
        for (int c = 0; c < causes.size(); c++) {
            List<Parameter> parameters = causes.get(c).parameters();
            double[] numbers = theta.get(c);
            if (parameters.size() != numbers.length) {
                return false;
            }
            for (int p = 0; p < numbers.length; p++) {
                if (parameters.get(p).clipped(numbers[p]) != numbers[p]) {
                    return false;
                }
            }
        }
        return true;
    }

    /** The same with other numbers, clipped to those that make sense. */
    public Hypothesis plus(double[] change) {
        return plus(change, this::clipped);
    }

    private Hypothesis plus(double[] change, UnaryOperator<Hypothesis> then) {
        List<double[]> next = new ArrayList<>();
        theta.forEach(t -> next.add(t.clone()));
        int i = 0;
        for (Place place : places()) {
            next.get(place.cause())[place.parameter()] += change[i++];
        }
        return then.apply(new Hypothesis(causes, next));
    }

    private Hypothesis clipped(Hypothesis of) {
        for (int c = 0; c < of.causes.size(); c++) {
            List<Parameter> parameters = of.causes.get(c).parameters();
            double[] numbers = of.theta.get(c);
            for (int p = 0; p < numbers.length; p++) {
                numbers[p] = parameters.get(p).clipped(numbers[p]);
            }
        }
        return of;
    }
}
