package org.auvsim.core.entity;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Volume;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;

/**
 * Everything that makes a world object, as an immutable value: what a scenario states, and what a
 * world turns into a live {@link WorldObject}.
 *
 * @param id a positive number; empty: the world gives the next free one
 * @param fixed whether it never moves, whatever hits it
 * @param mass (kg); needed unless fixed
 * @param restitution share of the approach speed that is left after a bounce, 0 to 1
 * @param friction coefficient of Coulomb friction, 0 or more; of two bodies the geometric mean
 *     counts
 * @param layer of collisions, 0 to 31
 * @param ignores the layers whose objects it does not meet
 * @param inertia moments and products of inertia about the centre of mass; empty: those of the
 *     volume with its mass
 * @param centreOfMass (m, body); empty: that of the volume
 * @param addedMass of the water that it carries with it
 * @param mount what holds it to some of its ways of motion; empty: it is free
 * @param position of the origin (m, world)
 * @param orientation body to world; normalised here
 * @param velocity of the origin (m/s, world)
 * @param angularVelocity (rad/s, world)
 * @param response what it does in a collision; empty: what the world does by default
 */
public record WorldObjectDefinition(
        OptionalLong id,
        String name,
        @Default("0") boolean fixed,
        @Unit("kg") OptionalDouble mass,
        @Default("1.0") double restitution,
        @Default("0.0") double friction,
        @Default("0") int layer,
        List<IgnoredLayer> ignores,
        Volume volume,
        Optional<Inertia> inertia,
        @Unit("m") Optional<Vec3> centreOfMass,
        Optional<AddedMass> addedMass,
        Optional<Mount> mount,
        @Unit("m") @Default("0 0 0") Vec3 position,
        @Default("1 0 0 0") Quat orientation,
        @Unit("m/s") @Default("0 0 0") Vec3 velocity,
        @Unit("rad/s") @Default("0 0 0") Vec3 angularVelocity,
        Optional<CollisionResponse> response,
        List<NamedForce> force,
        List<Effect> effect,
        List<Component> component) {
    /**
     * A checked definition.
     *
     * @throws IllegalArgumentException naming what is wrong: an id below 1, a blank name, a mass
     *     that is missing or not positive or on a volume that must be fixed, a number that is not
     *     finite, a name used twice, a component that another one needs
     */
    public WorldObjectDefinition {
        if (id.isPresent() && id.getAsLong() < 1) {
            throw new IllegalArgumentException("an id must be 1 or more, but is " + id.getAsLong());
        }
        if (name.isBlank()) {
            throw new IllegalArgumentException("a world object needs a name that is not blank");
        }
        if (mass.isEmpty() && !fixed) {
            throw new IllegalArgumentException(
                    "world object '" + name + "' needs a mass, unless it is fixed");
        }
        if (!(restitution >= 0 && restitution <= 1)) {
            throw new IllegalArgumentException("restitution must be 0 to 1, but is " + restitution);
        }
        if (!(friction >= 0) || Double.isInfinite(friction)) {
            throw new IllegalArgumentException(
                    "friction must be 0 or more and finite, but is " + friction);
        }
        IgnoredLayer.requireLayer(layer);
        ignores = List.copyOf(ignores);
        if (!centreOfMass.orElse(Vec3.ZERO).isFinite()) {
            throw new IllegalArgumentException(
                    "the centre of mass of '"
                            + name
                            + "' must be finite, but is "
                            + centreOfMass.get());
        }
        if (!(position.isFinite() && velocity.isFinite() && angularVelocity.isFinite())) {
            throw new IllegalArgumentException(
                    "position and velocities of '" + name + "' must be finite numbers");
        }
        if (Math.abs(orientation.norm() - 1) > 1e-15) {
            orientation = orientation.normalized();
        }
        force = List.copyOf(force);
        effect = List.copyOf(effect);
        component = List.copyOf(component);
        refuseTwins(name, "force", force.stream().map(NamedForce::name).toList());
        refuseTwins(name, "component", component.stream().map(Component::name).toList());
        for (Component c : component) {
            Need.require(name, c, component);
        }
        massProperties(mass, volume, inertia);
    }

    private static void refuseTwins(String object, String kind, List<String> names) {
        for (int i = 0; i < names.size(); i++) {
            if (names.subList(0, i).contains(names.get(i))) {
                throw new IllegalArgumentException(
                        "world object '%s' has two of the %s name '%s'; each needs its own"
                                .formatted(object, kind, names.get(i)));
            }
        }
    }

    private static Optional<MassProperties> massProperties(
            OptionalDouble mass, Volume volume, Optional<Inertia> inertia) {
        if (mass.isEmpty()) {
            return Optional.empty();
        }
        Mat3 ofVolume = volume.inertia(mass.getAsDouble());
        return Optional.of(
                new MassProperties(
                        mass.getAsDouble(), inertia.map(Inertia::toMatrix).orElse(ofVolume)));
    }

    /** Mass and inertia; empty for a fixed object without a mass. */
    public Optional<MassProperties> massProperties() {
        return massProperties(mass, volume, inertia);
    }

    /** Where its mass has its centre (m, body): as stated, or else that of the volume. */
    public Vec3 centreOfItsMass() {
        return centreOfMass.orElse(volume.centreOfMass());
    }

    /** Whether a behavior of its own tells an actuator what to do. */
    public boolean directs(Actuator actuator) {
        return component.stream().anyMatch(c -> c instanceof Behavior b && b.directs(actuator));
    }

    /** Mass about the origin in full; empty for a plain body, and for a fixed one. */
    Optional<SpatialInertia> spatialInertia() {
        Vec3 centre = centreOfItsMass();
        boolean plain = addedMass.isEmpty() && mount.isEmpty() && centre.norm() == 0;
        if (fixed || plain) {
            return Optional.empty();
        }
        return massProperties()
                .map(
                        dry ->
                                new SpatialInertia(
                                        dry,
                                        centre,
                                        addedMass.map(AddedMass::matrix).orElse(new double[36]),
                                        mount.stream().toList()));
    }

    /** The same with another id, or without one. */
    public WorldObjectDefinition withId(OptionalLong otherId) {
        Builder same = new Builder(this);
        same.id = otherId;
        return same.build();
    }

    /** The same with the present id, state, forces, effects and components of an object. */
    WorldObjectDefinition as(WorldObject object) {
        Builder same = new Builder(this);
        same.id = OptionalLong.of(object.id());
        same.position = object.position();
        same.orientation = object.orientation();
        same.velocity = object.velocity();
        same.angularVelocity = object.angularVelocity();
        same.forces = object.forces();
        same.effects = object.effects();
        same.components = object.components();
        return same.build();
    }

    /**
     * This definition of an object that moves as another one at a time (s), with the same forces on
     * it and its actuators told the same.
     */
    public WorldObjectDefinition goingOnAs(WorldObject object, double time) {
        Builder next = new Builder(as(object));
        next.effects = effect;
        next.components = new ArrayList<>(component);
        next.components.replaceAll(
                c ->
                        c instanceof Actuator actuator
                                ? object.component(Actuator.class, c.name())
                                        .map(
                                                told ->
                                                        (Component)
                                                                actuator.commanded(
                                                                        told.command(), time))
                                        .orElse(c)
                                : c);
        return next.build();
    }

    /** Starts a definition that is like this one in all that is not changed. */
    public Builder toBuilder() {
        return new Builder(this);
    }

    /** Starts a definition of an object that moves freely. */
    public static Builder named(String name) {
        return new Builder(name);
    }

    /** Collects what a definition needs; everything but volume and mass has a default. */
    public static final class Builder {
        private String name;
        private OptionalLong id = OptionalLong.empty();
        private boolean fixed;
        private OptionalDouble mass = OptionalDouble.empty();
        private double restitution = 1;
        private double friction;
        private int layer;
        private List<IgnoredLayer> ignores = new ArrayList<>();
        private Optional<Volume> volume = Optional.empty();
        private Optional<Inertia> inertia = Optional.empty();
        private Optional<Vec3> centreOfMass = Optional.empty();
        private Optional<AddedMass> addedMass = Optional.empty();
        private Optional<Mount> mount = Optional.empty();
        private Vec3 position = Vec3.ZERO;
        private Quat orientation = Quat.IDENTITY;
        private Vec3 velocity = Vec3.ZERO;
        private Vec3 angularVelocity = Vec3.ZERO;
        private Optional<CollisionResponse> response = Optional.empty();
        private List<NamedForce> forces = new ArrayList<>();
        private List<Effect> effects = new ArrayList<>();
        private List<Component> components = new ArrayList<>();

        private Builder(String name) {
            this.name = name;
        }

        private Builder(WorldObjectDefinition same) {
            name = same.name;
            id = same.id;
            fixed = same.fixed;
            mass = same.mass;
            restitution = same.restitution;
            friction = same.friction;
            layer = same.layer;
            ignores = new ArrayList<>(same.ignores);
            volume = Optional.of(same.volume);
            inertia = same.inertia;
            centreOfMass = same.centreOfMass;
            addedMass = same.addedMass;
            mount = same.mount;
            position = same.position;
            orientation = same.orientation;
            velocity = same.velocity;
            angularVelocity = same.angularVelocity;
            response = same.response;
            forces = new ArrayList<>(same.force);
            effects = new ArrayList<>(same.effect);
            components = new ArrayList<>(same.component);
        }

        /** Its name, in place of the first. */
        public Builder renamed(String other) {
            name = other;
            return this;
        }

        /** The effects, in place of those before. */
        public Builder effects(List<Effect> others) {
            effects = new ArrayList<>(others);
            return this;
        }

        /** The components, in place of those before. */
        public Builder components(List<Component> others) {
            components = new ArrayList<>(others);
            return this;
        }

        /** Its id, 1 or more; else the world gives the next free one. */
        public Builder id(long id) {
            this.id = OptionalLong.of(id);
            return this;
        }

        /** Makes it immovable. */
        public Builder fixed() {
            fixed = true;
            return this;
        }

        /** Mass (kg). */
        public Builder mass(double mass) {
            this.mass = OptionalDouble.of(mass);
            return this;
        }

        /** Share of the approach speed that is left after a bounce, 0 to 1. */
        public Builder restitution(double restitution) {
            this.restitution = restitution;
            return this;
        }

        /** Coefficient of Coulomb friction, 0 or more. */
        public Builder friction(double friction) {
            this.friction = friction;
            return this;
        }

        /** Its layer of collisions, 0 to 31. */
        public Builder layer(int layer) {
            this.layer = layer;
            return this;
        }

        /** Lets it pass through the objects of a layer, 0 to 31. */
        public Builder ignores(int layer) {
            ignores.add(new IgnoredLayer(layer));
            return this;
        }

        /** Its shape. */
        public Builder volume(Volume volume) {
            this.volume = Optional.of(volume);
            return this;
        }

        /** Inertia that differs from that of its volume with constant density. */
        public Builder inertia(Inertia inertia) {
            this.inertia = Optional.of(inertia);
            return this;
        }

        /** Centre of mass (m, body) that differs from that of its volume. */
        public Builder centreOfMass(Vec3 centreOfMass) {
            this.centreOfMass = Optional.of(centreOfMass);
            return this;
        }

        /** Added mass of the water. */
        public Builder addedMass(AddedMass addedMass) {
            this.addedMass = Optional.of(addedMass);
            return this;
        }

        /** Holds it to some of its ways of motion. */
        public Builder mount(Mount mount) {
            this.mount = Optional.of(mount);
            return this;
        }

        /** Position (m, world). */
        public Builder position(double x, double y, double z) {
            return position(new Vec3(x, y, z));
        }

        /** Position (m, world). */
        public Builder position(Vec3 position) {
            this.position = position;
            return this;
        }

        /** Orientation, body to world. */
        public Builder orientation(Quat orientation) {
            this.orientation = orientation;
            return this;
        }

        /** Velocity (m/s, world). */
        public Builder velocity(double x, double y, double z) {
            velocity = new Vec3(x, y, z);
            return this;
        }

        /** Angular velocity (rad/s, world). */
        public Builder angularVelocity(double x, double y, double z) {
            angularVelocity = new Vec3(x, y, z);
            return this;
        }

        /** What it does in a collision. */
        public Builder response(CollisionResponse response) {
            this.response = Optional.of(response);
            return this;
        }

        /** Adds a named force. */
        public Builder force(NamedForce force) {
            forces.add(force);
            return this;
        }

        /** Adds an effect. */
        public Builder effect(Effect effect) {
            effects.add(effect);
            return this;
        }

        /** Adds a propulsor, behavior or other component. */
        public Builder component(Component component) {
            components.add(component);
            return this;
        }

        /**
         * The definition.
         *
         * @throws IllegalArgumentException naming what is missing or wrong
         */
        public WorldObjectDefinition build() {
            return new WorldObjectDefinition(
                    id,
                    name,
                    fixed,
                    mass,
                    restitution,
                    friction,
                    layer,
                    ignores,
                    volume.orElseThrow(
                            () ->
                                    new IllegalArgumentException(
                                            "world object '" + name + "' needs a volume")),
                    inertia,
                    centreOfMass,
                    addedMass,
                    mount,
                    position,
                    orientation,
                    velocity,
                    angularVelocity,
                    response,
                    forces,
                    effects,
                    components);
        }
    }
}
