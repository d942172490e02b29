package org.auvsim.core.entity;

/**
 * A component that pushes its object: a propulsor, a fin. What a command changes in it is told by
 * its changed self ({@link WorldObject#replace}); what it does on its own until the next command is
 * a function of time ({@link Block#time}), so that it is exact in each stage of an integrator.
 */
public interface Actuator extends Component {
    /**
     * Adds its force and torque on body {@code i} of the block with {@link Block#addForce} and
     * {@link Block#addTorque}, or into the block's arrays, which costs no garbage.
     */
    void add(Block block, int i);
}
