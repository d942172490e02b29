package org.auvsim.auvsml.document;

/**
 * Which feedback processor the server uses, whatever the messages name.
 *
 * @param override the processor's name
 */
public record FeedbackProcessorChoice(String override) {}
