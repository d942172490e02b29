package org.auvsim.diagnosis.cause;

import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Something that a model may lack or have wrong; a whole family of it, by its parameters. It
 * changes the model by what a scenario can state, too, so that what is found can be written down.
 */
public interface Cause {
    /** Share of a parameter's scale by which smooth effects are moved. */
    double SMALL = 1e-3;

    /** What one out of a whole library must gain to be believed. */
    double PRICE = 12;

    /** By which reports name it, as {@code quadratic_drag}. */
    String id();

    /** The part of the body that it is about, as a propulsor's name. */
    default Optional<String> subject() {
        return Optional.empty();
    }

    /** The id and what it is about: {@code thruster_gain (port)}. */
    default String name() {
        return subject().map(of -> id() + " (" + of + ")").orElse(id());
    }

    /**
     * What tells it from all others, where several share a name: {@code thruster_misalignment (tilt
     * of port)}; the name, where none does.
     */
    default String label() {
        return name();
    }

    /** What it depends on. */
    List<Parameter> parameters();

    /**
     * The model with it.
     *
     * @param theta a number for each parameter
     */
    Variant in(Variant model, double[] theta);

    /** Where to begin; all parameters at 0, if nothing else is said. */
    default List<Guess> guesses(List<MeasuredRun> runs) {
        List<Double> zeros = new ArrayList<>();
        List<Double> steps = new ArrayList<>();
        for (Parameter parameter : parameters()) {
            zeros.add(0.0);
            steps.add(SMALL * parameter.scale());
        }
        return List.of(new Guess(zeros, IntStream.range(0, zeros.size()).boxed().toList(), steps));
    }

    /**
     * Where else to begin, once it was found with some numbers: those that look alike to each run
     * by itself, as frequencies do that runs far apart in time tell by their phases alone. Usually
     * none.
     */
    default List<Guess> aliases(double[] theta) {
        return List.of();
    }

    /** Its numbers as people know them: amplitude and phase rather than sine and cosine. */
    default List<Quantity> quantities(double[] theta) {
        return Quantity.of(parameters(), theta);
    }

    /**
     * What it must gain to be believed, in twice the logarithm of the likelihood, beside what its
     * parameters must.
     */
    default double price() {
        return PRICE;
    }

    /**
     * What it must gain in all, its parameters' share by Schwarz (1978).
     *
     * @param measured how many numbers there are to explain
     * @param independent how many independent ones tell as much, which are fewer where errors last
     */
    default double price(int measured, double independent) {
        long free = parameters().stream().filter(Parameter::isFree).count();
        return price() + free * StrictMath.log(measured);
    }

    /**
     * The same law with numbers more that runs seldom tell: its first ones are those of this cause,
     * the others begin as its guesses have them. It is tried where this cause leaves something.
     */
    default Optional<Cause> freer() {
        return Optional.empty();
    }

    /** Whether it is another one's law, with as many numbers or more or fewer. */
    default boolean isFormOf(Cause other) {
        return equals(other)
                || freer().filter(other::equals).isPresent()
                || other.freer().filter(this::equals).isPresent();
    }

    /** Whether it is in some form among some. */
    default boolean isAmong(List<Cause> some) {
        return some.stream().anyMatch(this::isFormOf);
    }

    /** Whether it can imitate many others and so counts only where none of those passes. */
    default boolean isGeneric() {
        return false;
    }
}
