package org.auvsim.auvsml.message.movement;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.MovementState;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;

/**
 * The state of a world object, after a step or as projected (thesis, appendix A.3).
 *
 * @param timestamp the world's time of this state
 * @param isProjectedState whether the step that ends so is still to be made
 * @param orientation turns body into world vectors; {@code xy} is row x, column y
 * @param angularMomentum about the object's origin, world axes
 */
public record MovementStateChangeMessage(
        @Unit("s") double timestamp,
        long worldObjectId,
        boolean isProjectedState,
        @Unit("m") Vec3 position,
        Mat3 orientation,
        @Unit("kg m/s") Vec3 linearMomentum,
        @Unit("kg m^2/s") Vec3 angularMomentum)
        implements Message {
    /** The message on a state of an object. */
    public static MovementStateChangeMessage of(
            double timestamp, long worldObjectId, boolean isProjectedState, MovementState state) {
        return new MovementStateChangeMessage(
                timestamp,
                worldObjectId,
                isProjectedState,
                state.position(),
                state.orientation().toMatrix(),
                state.linearMomentum(),
                state.angularMomentum());
    }
}
