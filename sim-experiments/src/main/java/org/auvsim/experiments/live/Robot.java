package org.auvsim.experiments.live;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.math.Vec3;

import java.util.List;

/** A robot: what it says about its world object. */
public interface Robot {
    /** What it sends before the first step. */
    List<Message> begin();

    /**
     * What it answers to a step, or to the projection of one.
     *
     * @param time at the step's end (s)
     * @param simulated where its object is then (m)
     */
    List<Message> answer(double time, Vec3 simulated);
}
