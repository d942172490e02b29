package org.auvsim.diagnosis.online;

import org.auvsim.core.entity.NamedForce;
import org.auvsim.server.feedback.Target;

import java.util.List;
import java.util.SortedMap;

/** Something that the learner hears of its object. Immutable. */
sealed interface Observation {
    /**
     * What actuators and forces are told from a time (s) on.
     *
     * @param levels of actuators by their names; of forces by name and axis, as {@code push.x} (N)
     * @param forces that act
     */
    record Told(double time, SortedMap<String, Double> levels, List<NamedForce> forces)
            implements Observation {}

    /**
     * What was measured at a time (s).
     *
     * @param target in the world's axes
     */
    record Measured(double time, Target target) implements Observation {}

    /**
     * The world's time has jumped, or something could not be heard: what follows has nothing to do
     * with what was before.
     */
    record Broken() implements Observation {}
}
