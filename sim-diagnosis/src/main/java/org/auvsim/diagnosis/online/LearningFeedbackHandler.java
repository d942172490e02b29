package org.auvsim.diagnosis.online;

import org.auvsim.auvsml.document.FeedbackProcessing;
import org.auvsim.auvsml.message.Message;
import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.world.World;
import org.auvsim.diagnosis.Method;
import org.auvsim.server.feedback.Correction;
import org.auvsim.server.simulator.AccompaniedProcessor;
import org.auvsim.server.simulator.Companion;

import java.util.List;
import java.util.function.Consumer;

/**
 * Corrects an object as another processor does, and learns meanwhile: what was measured and
 * commanded is diagnosed in the background, by {@link Method#SHOOTING}; what the model lacks is
 * announced and, if the scenario allows, added to the running world.
 *
 * @param correctsBy what corrects the object
 * @param extendsWorld whether the world gets what was found; else it is only announced
 * @param after so much that is new must have been measured before it is diagnosed (again)
 * @param keep so many samples are kept; the oldest make room
 * @param seed of what is drawn by lot
 */
public record LearningFeedbackHandler(
        @Default("kalman-filter") Corrector correctsBy,
        @Default("0") boolean extendsWorld,
        @Unit("s") @Default("30.0") double after,
        @Default("6000") int keep,
        @Default("1") long seed)
        implements FeedbackProcessing, AccompaniedProcessor {
    /**
     * A checked processor.
     *
     * @throws IllegalArgumentException if it would learn without pause, or keep too little
     */
    public LearningFeedbackHandler {
        var _ = plan(extendsWorld, after, keep, seed);
    }

    /** Filters, announces, and changes nothing. */
    public LearningFeedbackHandler() {
        this(Corrector.KALMAN_FILTER, false, 30, 6000, 1);
    }

    @Override
    public Phase phase() {
        return correctsBy.processor().phase();
    }

    @Override
    public boolean looksBack() {
        return correctsBy.processor().looksBack();
    }

    @Override
    public void process(Correction correction) {
        correctsBy.processor().process(correction);
    }

    @Override
    public Companion companion(World world, long objectId, Consumer<List<Message>> toSimulator) {
        return new Learner(
                objectId,
                Belief.of(world, objectId),
                plan(extendsWorld, after, keep, seed),
                toSimulator);
    }

    private static LearningPlan plan(boolean extendsWorld, double after, int keep, long seed) {
        return new LearningPlan(extendsWorld, after, keep, seed, Method.SHOOTING);
    }
}
