package org.auvsim.core.communication;

import org.auvsim.core.entity.Component;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.sensor.Noise;

/**
 * A component that sends messages to others of its own class and channel, and receives theirs. A
 * message travels as the front of a wave ({@link Transmission}).
 */
public interface Transceiver extends Component {
    /** Where it sits (m, body). */
    Vec3 position();

    /** Only transceivers of one channel hear each other. */
    String channel();

    /** How far its messages reach (m). */
    double range();

    /** How fast its waves travel (m/s). */
    double speed();

    /** Share of the messages that come to it and that it does not understand, 0 to 1. */
    double loss();

    /** Decides which messages are lost. */
    long seed();

    /** Whether it can send and receive at a place (m, world). */
    default boolean worksAt(Vec3 place) {
        return true;
    }

    /** Whether it understands messages of another one. */
    default boolean understands(Transceiver other) {
        return getClass() == other.getClass() && channel().equals(other.channel());
    }

    /** Whether a message that comes to it, as part of an object, is lost on it. */
    default boolean loses(long objectId, long messageId) {
        return Noise.of(seed(), objectId, name(), messageId).uniform(0) < loss();
    }
}
