package org.auvsim.viz.scene;

import org.auvsim.core.entity.NamedForce;

import java.util.List;

/**
 * An object as it is to be shown at the scene's time. It is the scene's own and changes with the
 * next look: read it while looking, and keep nothing of it. Nothing here makes an object.
 */
public interface ActorView {
    /** What it is. */
    SeenObject object();

    /** How far it reaches from its origin (m); infinite if it has no end, 0 if it is not known. */
    double radius();

    /** Coordinate {@code axis} (0 x, 1 y, 2 z) of its origin (m, world). */
    double position(int axis);

    /** Component {@code k} (w, x, y, z) of its orientation, body to world. */
    double orientation(int k);

    /** Component {@code axis} of its velocity (m/s, world). */
    double velocity(int axis);

    /** Component {@code axis} of its angular velocity (rad/s, world). */
    double angularVelocity(int axis);

    /** Whether it is known where its last step was to bring it, or the one under way will. */
    boolean isProjected();

    /** Coordinate {@code axis} of where that step was to bring it (m, world). */
    double projectedPosition(int axis);

    /** Component {@code k} of its orientation then, body to world. */
    double projectedOrientation(int k);

    /** Whether a robot has measured lately where it is. */
    boolean isMeasured();

    /** Coordinate {@code axis} of where the robot measured that it is (m, world). */
    double measuredPosition(int axis);

    /** How many of its last places are known. */
    int trailLength();

    /** Coordinate {@code axis} of place {@code i} of its trail, 0 the oldest (m, world). */
    double trail(int i, int axis);

    /** When it was at place {@code i} of its trail (s). */
    double trailTime(int i);

    /** Its speed at place {@code i} of its trail (m/s). */
    double trailSpeed(int i);

    /** Its yaw at place {@code i} of its trail (rad). */
    double trailYaw(int i);

    /** The forces that somebody has set on it. */
    List<NamedForce> forces();
}
