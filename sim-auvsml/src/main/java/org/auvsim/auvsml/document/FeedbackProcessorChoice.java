package org.auvsim.auvsml.document;

import java.util.List;
import java.util.Optional;

/**
 * How feedback is used.
 *
 * @param override the processor that the server uses, whatever the messages name; empty: the one
 *     that each names
 * @param processor those that are to work otherwise than by default
 */
public record FeedbackProcessorChoice(
        Optional<String> override, List<FeedbackProcessing> processor) {
    /** The processor of a name, as it is by default. */
    public FeedbackProcessorChoice(String override) {
        this(Optional.of(override), List.of());
    }
}
