package org.auvsim.auvsml.message.command;

import org.auvsim.core.communication.Transceiver;
import org.auvsim.core.entity.NamedForce;

/** What a {@link WorldObjectCommand} can do: one world object, between two steps. */
public interface WorldObjectControl {
    /**
     * Sets a named force, which acts until it is removed; one of the same name is replaced.
     *
     * @throws RefusedException if its point lies outside the object's volume
     */
    void apply(NamedForce force);

    /**
     * Removes a named force.
     *
     * @throws RefusedException if the object has none of this name
     */
    void removeForce(String name);

    /**
     * Sets how hard a propulsor pushes.
     *
     * @param level -1 (full astern) to 1 (full ahead)
     * @throws RefusedException if the object has no propulsor of this name
     */
    void setPropulsorLevel(String name, double level);

    /**
     * Turns a fin.
     *
     * @param angle (rad)
     * @throws RefusedException if the object has no fin of this name, or it cannot turn so far
     */
    void setControlSurface(String name, double angle);

    /**
     * Sends a message.
     *
     * @param kind of the transceiver
     * @param transceiver its name
     * @throws RefusedException if the object has no such transceiver
     */
    void transmit(Class<? extends Transceiver> kind, String transceiver, String text);
}
