package org.auvsim.server.feedback;

/**
 * Makes a correction out of what a robot has measured (thesis, section 7.2).
 *
 * <p>Feedback messages name the processor they want by its {@link #name()}. Implementations are
 * immutable; what one has to remember of an object, it leaves with the {@link Correction}. They
 * subclass {@code FeedbackProcessorContract} in their tests.
 */
public interface FeedbackProcessor {
    /** When, in a step, a processor works. */
    enum Phase {
        /** Before the world makes the step: the correction goes through collision detection. */
        BEFORE_STEP,
        /** When the world has made the step. */
        AFTER_STEP
    }

    /** The name by which messages and configurations choose it; by default its class's. */
    default String name() {
        return getClass().getSimpleName();
    }

    /** When it works. */
    Phase phase();

    /** Whether, after the step, it tries the step again; the world before it is kept for that. */
    default boolean looksBack() {
        return false;
    }

    /**
     * Corrects one object, which is not fixed.
     *
     * @throws org.auvsim.auvsml.message.command.RefusedException if this object cannot be corrected
     *     so; then nothing has changed
     */
    void process(Correction correction);
}
