package org.auvsim.core.entity;

/**
 * What a world object does of its own accord: called once before each step, objects in order of id,
 * behaviors in the order in which they were added.
 */
public interface Behavior extends Component {
    /**
     * Sets named forces and propulsor levels of {@code self}, and no more, from the world's time
     * (s) and the object's state.
     */
    void act(double time, WorldObject self);
}
