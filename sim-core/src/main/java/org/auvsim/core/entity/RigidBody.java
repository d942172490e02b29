package org.auvsim.core.entity;

import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Volume;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A rigid body (thesis, section 5.2): a live view on one slot of its world's {@link BodyState}.
 *
 * <p>It belongs to the thread that owns the world; what leaves that thread is its {@link
 * #movementState}.
 */
public class RigidBody implements Collidable {
    private final long id;
    private final WorldObjectDefinition definition;
    private final BodyState state;
    private int slot;
    private final Map<String, NamedForce> forces = new LinkedHashMap<>();
    private final List<Effect> effects;

    RigidBody(long id, WorldObjectDefinition definition, BodyState state) {
        this.id = id;
        this.definition = definition;
        this.state = state;
        this.slot = state.add(definition);
        this.effects = new ArrayList<>(definition.effect());
        definition.force().forEach(force -> forces.put(force.name(), force));
        setOrientation(definition.orientation());
        setPosition(definition.position());
        setVelocity(definition.velocity());
        setAngularVelocity(definition.angularVelocity());
    }

    /** The same body in a copy of its world's state. */
    RigidBody(RigidBody original, BodyState copiedState) {
        id = original.id;
        definition = original.definition;
        state = copiedState;
        slot = original.slot;
        forces.putAll(original.forces);
        effects = new ArrayList<>(original.effects);
    }

    @Override
    public final long id() {
        return id;
    }

    @Override
    public final String name() {
        return definition.name();
    }

    /** What it was made from; constants hold for ever, the rest was its beginning. */
    public final WorldObjectDefinition definition() {
        return definition;
    }

    /** Its place in the world's arrays. */
    public final int slot() {
        return slot;
    }

    final void moveToSlot(int slot) {
        this.slot = slot;
    }

    /** Whether it never moves. */
    public final boolean isFixed() {
        return definition.fixed();
    }

    /** Mass (kg); 0 for a fixed body. */
    public final double mass() {
        return state.mass()[slot];
    }

    /** Its layer of collisions, 0 to {@value IgnoredLayer#LAST}. */
    public final int layer() {
        return definition.layer();
    }

    /** The layers that it passes through as bits: layer k is bit k. */
    public final int ignoredLayers() {
        return IgnoredLayer.mask(definition.ignores());
    }

    /** Whether neither of the two ignores the other's layer. */
    public final boolean meetsLayerOf(RigidBody other) {
        return ((ignoredLayers() >>> other.layer()) & 1) == 0
                && ((other.ignoredLayers() >>> layer()) & 1) == 0;
    }

    /** Its shape. */
    public final Volume volume() {
        return definition.volume();
    }

    @Override
    public final Volume volumeAt(double time) {
        return definition.volume();
    }

    @Override
    public final Vec3 positionAt(double time) {
        return position();
    }

    @Override
    public final Quat orientationAt(double time) {
        return orientation();
    }

    @Override
    public final Optional<CollisionResponse> response() {
        return definition.response();
    }

    private Vec3 vector(int column) {
        return new Vec3(
                state.column(column)[slot],
                state.column(column + 1)[slot],
                state.column(column + 2)[slot]);
    }

    private void requireFinite(Vec3 v, String what) {
        if (!v.isFinite()) {
            throw new IllegalArgumentException(
                    what + " of '" + name() + "' must be finite, but is " + v);
        }
    }

    private void setVector(int column, Vec3 v, String what) {
        requireFinite(v, what);
        state.column(column)[slot] = v.x();
        state.column(column + 1)[slot] = v.y();
        state.column(column + 2)[slot] = v.z();
    }

    /** Position of the origin (m, world). */
    public final Vec3 position() {
        return vector(BodyState.X);
    }

    /** Moves it, and nothing else: momenta and orientation stay. */
    public final void setPosition(Vec3 position) {
        setVector(BodyState.X, position, "position");
    }

    /** Orientation, body to world. */
    public final Quat orientation() {
        return new Quat(
                state.column(BodyState.QW)[slot],
                state.column(BodyState.QX)[slot],
                state.column(BodyState.QY)[slot],
                state.column(BodyState.QZ)[slot]);
    }

    /** Turns it, and nothing else: the momenta stay. */
    public final void setOrientation(Quat orientation) {
        Quat unit =
                Math.abs(orientation.norm() - 1) > 1e-15 ? orientation.normalized() : orientation;
        state.column(BodyState.QW)[slot] = unit.w();
        state.column(BodyState.QX)[slot] = unit.x();
        state.column(BodyState.QY)[slot] = unit.y();
        state.column(BodyState.QZ)[slot] = unit.z();
    }

    /** Linear momentum (kg m/s, world). */
    public final Vec3 linearMomentum() {
        return vector(BodyState.PX);
    }

    /** Replaces the linear momentum (kg m/s, world); that of a fixed or held body stays zero. */
    public final void setLinearMomentum(Vec3 momentum) {
        SpatialInertia spatial = state.spatial(slot);
        Vec3 free = spatial == null ? momentum : spatial.freeLinear(momentum);
        setVector(BodyState.PX, isFixed() ? free.times(0) : free, "linear momentum");
    }

    /** Angular momentum about the origin (kg m^2/s, world). */
    public final Vec3 angularMomentum() {
        return vector(BodyState.LX);
    }

    /** Replaces the angular momentum (kg m^2/s, world); that of a fixed or held body stays zero. */
    public final void setAngularMomentum(Vec3 momentum) {
        SpatialInertia spatial = state.spatial(slot);
        Vec3 free = spatial == null ? momentum : spatial.freeAngular(momentum);
        setVector(BodyState.LX, isFixed() ? free.times(0) : free, "angular momentum");
    }

    /** Velocity of the origin (m/s, world). */
    public final Vec3 velocity() {
        return twist().velocity();
    }

    /** Velocity and angular velocity. */
    public final Twist twist() {
        return twistOf(movementState());
    }

    /** Velocity and angular velocity that it would have in a state. */
    public final Twist twistOf(MovementState at) {
        SpatialInertia spatial = state.spatial(slot);
        if (spatial != null) {
            return spatial.twist(at, water(spatial, at.position()));
        }
        return new Twist(
                at.linearMomentum().times(state.inverseMass()[slot]),
                inverseInertia(at.orientation()).times(at.angularMomentum()));
    }

    private Vec3 water(SpatialInertia spatial, Vec3 position) {
        return spatial.hasAddedMass() ? state.waterAround(slot, position) : Vec3.ZERO;
    }

    private void setTwist(SpatialInertia spatial, Twist twist) {
        Vec3[] momenta = spatial.momenta(twist, orientation(), water(spatial, position()));
        setVector(BodyState.PX, momenta[0], "linear momentum");
        setVector(BodyState.LX, momenta[1], "angular momentum");
    }

    /** Sets the momenta to those of this velocity (m/s, world) and the present angular velocity. */
    public final void setVelocity(Vec3 velocity) {
        SpatialInertia spatial = state.spatial(slot);
        if (spatial != null) {
            setTwist(spatial, new Twist(velocity, angularVelocity()));
            return;
        }
        setLinearMomentum(velocity.times(mass()));
    }

    /** Angular velocity (rad/s, world). */
    public final Vec3 angularVelocity() {
        return twist().angularVelocity();
    }

    /**
     * Sets the momenta to those of this angular velocity (rad/s, world) and the present velocity.
     */
    public final void setAngularVelocity(Vec3 angularVelocity) {
        if (isFixed()) {
            return;
        }
        SpatialInertia spatial = state.spatial(slot);
        if (spatial != null) {
            setTwist(spatial, new Twist(velocity(), angularVelocity));
            return;
        }
        Quat turn = orientation();
        Mat3 inertia = definition.massProperties().orElseThrow().inertia();
        Vec3 inBody = inertia.times(turn.rotateInverse(angularVelocity));
        setAngularMomentum(turn.rotate(inBody));
    }

    /**
     * Sets the momenta to those of this velocity (m/s) and angular velocity (rad/s), world axes, at
     * once: one after the other, each finds out first what the other is. That of a fixed body stays
     * zero.
     *
     * @throws IllegalArgumentException if one is not finite; nothing is set then
     */
    public final void setTwist(Twist twist) {
        requireFinite(twist.velocity(), "velocity");
        requireFinite(twist.angularVelocity(), "angular velocity");
        SpatialInertia spatial = state.spatial(slot);
        if (spatial != null && !isFixed()) {
            setTwist(spatial, twist);
            return;
        }
        setVelocity(twist.velocity());
        setAngularVelocity(twist.angularVelocity());
    }

    /** The inverse of its inertia in the world's axes; zeros for a fixed body. */
    public final Mobility mobility() {
        Quat q = orientation();
        double[] k = new double[36];
        state.inverseInertia6(slot, q.w(), q.x(), q.y(), q.z(), k, 0);
        return Mobility.of(k);
    }

    private Mat3 inverseInertia(Quat orientation) {
        double xy = state.inverseInertia(BodyState.IXY)[slot];
        double xz = state.inverseInertia(BodyState.IXZ)[slot];
        double yz = state.inverseInertia(BodyState.IYZ)[slot];
        Mat3 body =
                new Mat3(
                        state.inverseInertia(BodyState.IXX)[slot],
                        xy,
                        xz,
                        xy,
                        state.inverseInertia(BodyState.IYY)[slot],
                        yz,
                        xz,
                        yz,
                        state.inverseInertia(BodyState.IZZ)[slot]);
        Mat3 turn = orientation.toMatrix();
        return turn.times(body).times(turn.transposed());
    }

    /** Position, orientation and momenta as an immutable record. */
    public final MovementState movementState() {
        return new MovementState(position(), orientation(), linearMomentum(), angularMomentum());
    }

    /** Sets position, orientation and momenta. */
    public final void setMovementState(MovementState to) {
        setPosition(to.position());
        setOrientation(to.orientation());
        setLinearMomentum(to.linearMomentum());
        setAngularMomentum(to.angularMomentum());
    }

    /** What a collision response may know of it. */
    public final BodyMotion motion() {
        return new BodyMotion(
                movementState(),
                velocity(),
                angularVelocity(),
                mobility(),
                definition.restitution(),
                definition.friction());
    }

    /** The named forces on it, in the order in which they were first applied. */
    public final List<NamedForce> forces() {
        return List.copyOf(forces.values());
    }

    /** Applies a force until it is removed; replaces the one of the same name. */
    public final void applyForce(NamedForce force) {
        if (!force.equals(forces.put(force.name(), force))) {
            resultantChanged();
        }
    }

    /** Removes a named force; false if there is none of that name. */
    public final boolean removeForce(String forceName) {
        boolean removed = forces.remove(forceName) != null;
        if (removed) {
            resultantChanged();
        }
        return removed;
    }

    /** Replaces all named forces. */
    public final void setForces(List<NamedForce> to) {
        forces.clear();
        to.forEach(force -> forces.put(force.name(), force));
        resultantChanged();
    }

    /** Takes stock again of what pushes it, after a force or an actuator has changed. */
    final void resultantChanged() {
        state.applied().set(slot, forces.values(), actuators());
        state.actuators().set(slot, actuators());
    }

    final void behaviorsChanged() {
        state.behaviorsChanged();
    }

    final void equipmentChanged() {
        state.equipmentChanged();
    }

    /** World time (s) of its state. */
    final double time() {
        return state.time();
    }

    /** What pushes it as it is told to. */
    public List<Actuator> actuators() {
        return List.of();
    }

    /** Lets an effect act on it from now on. */
    final void addEffect(Effect effect) {
        effects.add(effect);
    }

    /** Ends an effect on it; the first of equal ones. False if there is none. */
    final boolean removeEffect(Effect effect) {
        return effects.remove(effect);
    }

    /** The effects on it. */
    public final List<Effect> effects() {
        return List.copyOf(effects);
    }
}
