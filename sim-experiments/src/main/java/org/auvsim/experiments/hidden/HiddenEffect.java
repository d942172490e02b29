package org.auvsim.experiments.hidden;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.UnaryOperator;

/** Something that is otherwise than the model has it. Immutable. */
public final class HiddenEffect {
    private final String cause;
    private final Optional<String> subject;
    private final SortedMap<String, List<Double>> parameters;
    private final UnaryOperator<Reality> change;

    private HiddenEffect(
            String cause,
            Optional<String> subject,
            SortedMap<String, List<Double>> parameters,
            UnaryOperator<Reality> change) {
        this.cause = cause;
        this.subject = subject;
        this.parameters = Collections.unmodifiableSortedMap(parameters);
        this.change = change;
    }

    static HiddenEffect of(
            String cause, Map<String, List<Double>> parameters, UnaryOperator<Reality> change) {
        return new HiddenEffect(cause, Optional.empty(), new TreeMap<>(parameters), change);
    }

    HiddenEffect about(String part) {
        return new HiddenEffect(cause, Optional.of(part), parameters, change);
    }

    /** Its id in the library of causes, or what it is if no cause covers it. */
    public String cause() {
        return cause;
    }

    /** The part of the body that it is about. */
    public Optional<String> subject() {
        return subject;
    }

    /** Its numbers by name, each as one number or as the coordinates of a vector. */
    public SortedMap<String, List<Double>> parameters() {
        return parameters;
    }

    /** What it makes of reality. */
    UnaryOperator<Reality> change() {
        return change;
    }

    /** Its id and what it is about: {@code thruster_gain (port)}. */
    public String name() {
        return subject.map(of -> cause + " (" + of + ")").orElse(cause);
    }

    @Override
    public String toString() {
        List<String> numbers = new ArrayList<>();
        parameters.forEach(
                (name, values) ->
                        numbers.add(
                                name
                                        + " "
                                        + String.join(
                                                " ",
                                                values.stream()
                                                        .map(
                                                                v ->
                                                                        String.format(
                                                                                Locale.ROOT,
                                                                                "%.4g",
                                                                                v))
                                                        .toList())));
        return name() + numbers;
    }
}
