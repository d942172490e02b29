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

    /**
     * Whether it tells an actuator of its object what to do: one that it needs, unless it says
     * otherwise. Where a log tells what the actuator was told, as in a diagnosis, the behavior does
     * not act.
     */
    default boolean directs(Actuator actuator) {
        return needs().filter(need -> need.isMetBy(actuator)).isPresent();
    }
}
