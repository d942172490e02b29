package org.auvsim.server.feedback;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.document.FeedbackProcessing;
import org.auvsim.auvsml.mapping.ContextClasses;
import org.auvsim.auvsml.message.command.RefusedException;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/** The feedback processors of a simulator, by name. */
public final class FeedbackProcessors {
    private final Map<String, FeedbackProcessor> byName = new TreeMap<>();
    private final Map<String, FeedbackProcessor> byScenario = new TreeMap<>();
    private Optional<String> override = Optional.empty();

    /**
     * Direct alteration and vector adjustment, as the thesis names them, the others of this
     * package, and those that provider files name, {@code
     * META-INF/services/org.auvsim.server.feedback.FeedbackProcessor}.
     *
     * @throws IllegalArgumentException if one of the latter cannot be had
     */
    public static FeedbackProcessors standard() {
        return standard(ContextClasses.loader());
    }

    static FeedbackProcessors standard(ClassLoader classes) {
        FeedbackProcessors processors = new FeedbackProcessors();
        processors.add(new DirectPositionChangeFeedbackHandler());
        processors.add(new VectorAdjustmentFeedbackHandler());
        processors.add(new KalmanFilterFeedbackHandler());
        processors.add(new IgnoreFeedbackHandler());
        try {
            ServiceLoader.load(FeedbackProcessor.class, classes).forEach(processors::add);
        } catch (ServiceConfigurationError e) {
            throw new IllegalArgumentException(
                    "a feedback processor that a provider file names cannot be had (%s); it must be"
                                    .formatted(e.getMessage())
                            + " a public class with a public constructor without parameters",
                    e);
        }
        return processors;
    }

    /**
     * The processor that a scenario states.
     *
     * @throws IllegalArgumentException if it is none of a server
     */
    public static FeedbackProcessor of(FeedbackProcessing stated) {
        return switch (stated) {
            case FeedbackProcessor own -> own;
            case FeedbackProcessing.VectorAdjustmentFeedbackHandler vector ->
                    new VectorAdjustmentFeedbackHandler(vector.momentum());
            case FeedbackProcessing.KalmanFilterFeedbackHandler filter ->
                    new KalmanFilterFeedbackHandler(
                            filter.acceleration(),
                            filter.angularAcceleration(),
                            filter.measurement(),
                            filter.initial());
            default ->
                    throw new IllegalArgumentException(
                            "%s is no feedback processor of this server: its record must be"
                                            .formatted(stated.getClass().getSimpleName())
                                    + " a %s too"
                                            .formatted(FeedbackProcessor.class.getSimpleName()));
        };
    }

    private FeedbackProcessors() {}

    /** Adds a processor, in place of one of the same name. */
    public void add(FeedbackProcessor processor) {
        byName.put(processor.name(), processor);
    }

    /**
     * Lets a scenario say which processors work otherwise than by default, and which one does all
     * corrections, whichever the messages name.
     *
     * @throws RefusedException if there is none of that name; then nothing has changed
     */
    public void configure(List<FeedbackProcessor> stated, Optional<String> overriding) {
        Map<String, FeedbackProcessor> before = Map.copyOf(byScenario);
        byScenario.clear();
        stated.forEach(processor -> byScenario.put(processor.name(), processor));
        try {
            override = overriding.map(this::known).map(FeedbackProcessor::name);
        } catch (RefusedException e) {
            byScenario.clear();
            byScenario.putAll(before);
            throw e;
        }
    }

    /**
     * Lets one processor do all corrections, whichever the messages name.
     *
     * @throws RefusedException if there is none of this name
     */
    public void override(String name) {
        override = Optional.of(known(name).name());
    }

    /** Lets each message name the processor again. */
    public void overrideNone() {
        override = Optional.empty();
    }

    /**
     * The processor that a message names, or the one that overrides it.
     *
     * @throws RefusedException if there is none of this name
     */
    public FeedbackProcessor named(String name) {
        return known(override.orElse(name));
    }

    private FeedbackProcessor known(String name) {
        FeedbackProcessor processor = byScenario.getOrDefault(name, byName.get(name));
        if (processor == null) {
            Set<String> names = new TreeSet<>(byName.keySet());
            names.addAll(byScenario.keySet());
            throw new RefusedException(
                    ErrorCode.UNKNOWN_ENTITY,
                    "no feedback processor has the name '%s'; there are %s"
                            .formatted(name, String.join(", ", names)));
        }
        return processor;
    }
}
