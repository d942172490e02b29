package org.auvsim.diagnosis.online;

import org.auvsim.auvsml.document.FeedbackProcessing;
import org.auvsim.core.world.World;
import org.auvsim.diagnosis.Method;
import org.auvsim.server.feedback.Correction;
import org.auvsim.server.simulator.AccompaniedProcessor;
import org.auvsim.server.simulator.Companion;
import org.auvsim.server.simulator.Messenger;

/** Corrects an object as another processor does, and lets a learner go along. */
interface LearningProcessor extends FeedbackProcessing, AccompaniedProcessor {
    /** What corrects the object. */
    Corrector correctsBy();

    /** Whether the world gets what was found; else it is only announced. */
    boolean extendsWorld();

    /** So much (s) that is new must have been measured before it is diagnosed (again). */
    double after();

    /** So many samples are kept; the oldest make room. */
    int keep();

    /** Of what is drawn by lot. */
    long seed();

    /** How causes are searched for. */
    Method method();

    @Override
    default Phase phase() {
        return correctsBy().processor().phase();
    }

    @Override
    default boolean looksBack() {
        return correctsBy().processor().looksBack();
    }

    @Override
    default void process(Correction correction) {
        correctsBy().processor().process(correction);
    }

    @Override
    default Companion companion(World world, long objectId, Messenger toSimulator) {
        LearningPlan plan = new LearningPlan(extendsWorld(), after(), keep(), seed(), method());
        return new Learner(objectId, Belief.of(world, objectId), plan, toSimulator);
    }
}
