package org.auvsim.core.entity;

import java.util.Optional;

/**
 * A component that pushes its object as it is told to: a propulsor, a fin. What a command changes
 * in it is told by its changed self ({@link WorldObject#command}); what it does on its own until
 * the next command is a function of time ({@link Block#time}), so that it is exact in each stage of
 * an integrator.
 */
public interface Actuator extends Component {
    /** What it has last been told; the unit is its own: a level, an angle (rad). */
    double command();

    /**
     * The same actuator told something else at a time (s).
     *
     * @throws IllegalArgumentException if it is outside what the actuator can do
     */
    Actuator commanded(double command, double time);

    /**
     * Its force and torque in the body's axes if they are constant until the next command, which
     * costs a step nothing; empty: {@link #add} tells them.
     */
    default Optional<Wrench> constantPush() {
        return Optional.empty();
    }

    /**
     * Whether its force and torque in the body's axes depend on time alone, whatever the body does:
     * {@link #push} tells them then, once for all bodies that carry it.
     */
    default boolean isTimed() {
        return false;
    }

    /**
     * Adds its force and torque in the body's axes, at the block's time, to those of others, if it
     * is timed. The same as {@link #add} adds to a body.
     *
     * @param sum force (N), then torque about the origin (N m)
     * @throws IllegalStateException if it is not timed
     */
    default void push(Block block, double[] sum) {
        throw new IllegalStateException("'%s' is not timed".formatted(name()));
    }

    /**
     * Adds its force and torque on body {@code i} of the block with {@link Block#addForce} and
     * {@link Block#addTorque}, or with {@link Block#addFromBody}, which costs no garbage.
     */
    void add(Block block, int i);
}
