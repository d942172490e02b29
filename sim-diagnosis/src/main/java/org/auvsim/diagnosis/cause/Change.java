package org.auvsim.diagnosis.cause;

import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/**
 * A cause that is a law with numbers. Those of its numbers that its guesses move are its strengths:
 * while all of them are 0 it leaves the model as it is. Immutable.
 */
final class Change implements Cause {
    private final String id;
    private final Optional<String> subject;
    private final Optional<String> aspect;
    private final List<Parameter> parameters;
    private final List<Guess> guesses;
    private final int[] strengths;
    private final boolean generic;
    private final Optional<Cause> freer;
    private final Law law;
    private final Function<double[], List<Quantity>> telling;
    private final Function<double[], List<Guess>> aliases;

    /** How numbers, of which one strength at least is not 0, change a model. */
    interface Law {
        Variant in(Variant model, double[] theta);
    }

    private Change(
            String id,
            Optional<String> subject,
            Optional<String> aspect,
            List<Parameter> parameters,
            List<Guess> guesses,
            boolean generic,
            Optional<Cause> freer,
            Law law,
            Function<double[], List<Quantity>> telling,
            Function<double[], List<Guess>> aliases) {
        this.id = id;
        this.subject = subject;
        this.aspect = aspect;
        this.parameters = List.copyOf(parameters);
        this.guesses = List.copyOf(guesses);
        this.strengths =
                guesses.stream()
                        .flatMapToInt(g -> g.columns().stream().mapToInt(c -> c))
                        .distinct()
                        .toArray();
        this.generic = generic;
        this.freer = freer;
        this.law = law;
        this.telling = telling;
        this.aliases = aliases;
    }

    /** One all of whose parameters are strengths, to begin at 0, and told as they are. */
    static Change of(String id, List<Parameter> parameters, Law law) {
        int[] all = IntStream.range(0, parameters.size()).toArray();
        return new Change(
                id,
                Optional.empty(),
                Optional.empty(),
                parameters,
                List.of(guess(parameters, new double[parameters.size()], all)),
                false,
                Optional.empty(),
                law,
                theta -> Quantity.of(parameters, theta),
                _ -> List.of());
    }

    /** A guess whose columns are moved by small steps. */
    static Guess guess(List<Parameter> parameters, double[] theta, int... columns) {
        return new Guess(
                boxed(theta),
                IntStream.of(columns).boxed().toList(),
                IntStream.of(columns).mapToObj(c -> SMALL * parameters.get(c).scale()).toList());
    }

    /** A guess of one number at 0 that is moved by a step of this size. */
    static Guess secant(double step) {
        return new Guess(List.of(0.0), List.of(0), List.of(step));
    }

    /** The same of a number that does nothing before it is moved so far. */
    static Guess beyond(double step) {
        return new Guess(List.of(0.0), List.of(0), List.of(step), true);
    }

    private static List<Double> boxed(double[] numbers) {
        return DoubleStream.of(numbers).boxed().toList();
    }

    /** The same about a part of the body. */
    Change about(String part) {
        return with(Optional.of(part), aspect, guesses, generic, freer, telling, aliases);
    }

    /** The same, one of several that share a name. */
    Change by(String one) {
        return with(subject, Optional.of(one), guesses, generic, freer, telling, aliases);
    }

    private Change with(
            Optional<String> part,
            Optional<String> one,
            List<Guess> begun,
            boolean isGeneric,
            Optional<Cause> freed,
            Function<double[], List<Quantity>> told,
            Function<double[], List<Guess>> alike) {
        return new Change(id, part, one, parameters, begun, isGeneric, freed, law, told, alike);
    }

    /** The same with other places to begin. */
    Change from(List<Guess> others) {
        return with(subject, aspect, others, generic, freer, telling, aliases);
    }

    /** The same that counts only where nothing specific passes. */
    Change asGeneric() {
        return with(subject, aspect, guesses, true, freer, telling, aliases);
    }

    /** The same, which where it leaves something may have the numbers of another one. */
    Change freedAs(Cause other) {
        return with(subject, aspect, guesses, generic, Optional.of(other), telling, aliases);
    }

    /** The same, to begin elsewhere too, once some numbers were found. */
    Change withAliases(Function<double[], List<Guess>> alike) {
        return with(subject, aspect, guesses, generic, freer, telling, alike);
    }

    /** The same, its numbers told otherwise. */
    Change told(Function<double[], List<Quantity>> otherwise) {
        return with(subject, aspect, guesses, generic, freer, otherwise, aliases);
    }

    /** The same, its numbers told as factors: 1 more. */
    Change toldAsFactors() {
        return told(
                theta ->
                        Quantity.of(
                                parameters,
                                Arrays.stream(theta).map(excess -> 1 + excess).toArray()));
    }

    @Override
    public String id() {
        return id;
    }

    @Override
    public Optional<String> subject() {
        return subject;
    }

    @Override
    public String label() {
        if (aspect.isEmpty()) {
            return name();
        }
        String about = subject.map(part -> aspect.get() + " of " + part).orElse(aspect.get());
        return "%s (%s)".formatted(id, about);
    }

    @Override
    public List<Parameter> parameters() {
        return parameters;
    }

    @Override
    public Variant in(Variant model, double[] theta) {
        for (int strength : strengths) {
            if (theta[strength] != 0) {
                return law.in(model, theta);
            }
        }
        return model;
    }

    @Override
    public List<Guess> guesses(List<MeasuredRun> runs) {
        return guesses;
    }

    @Override
    public List<Guess> aliases(double[] theta) {
        return aliases.apply(theta);
    }

    @Override
    public List<Quantity> quantities(double[] theta) {
        return telling.apply(theta);
    }

    @Override
    public Optional<Cause> freer() {
        return freer;
    }

    @Override
    public boolean isGeneric() {
        return generic;
    }

    @Override
    public String toString() {
        return label();
    }
}
