package org.auvsim.core.world;

import org.auvsim.core.dynamics.ImpulseResponse;
import org.auvsim.core.dynamics.Integrator;
import org.auvsim.core.dynamics.Rk4;
import org.auvsim.core.entity.CollisionResponse;
import org.auvsim.core.entity.Entity;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.sensor.Datum;
import org.auvsim.core.step.EventStepper;
import org.auvsim.core.step.Lanes;
import org.auvsim.core.step.Stepper;
import org.auvsim.core.volume.PairQueries;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;

/** Collects what a world is made of; everything has a default. */
public final class WorldBuilder {
    double startTime;
    Optional<Datum> datum = Optional.empty();
    double timeStep = 0.05;
    Stepper stepper = EventStepper.standard();
    Integrator integrator = new Rk4();
    CollisionResponse response = new ImpulseResponse();
    PairQueries queries = PairQueries.standard();
    Lanes lanes = Lanes.ONE;
    boolean asBoundingSpheres;
    private boolean overlapsAllowed;
    private final List<Entity> entities = new ArrayList<>();
    private final List<WorldObjectDefinition> objects = new ArrayList<>();

    WorldBuilder() {}

    /** The time (s) at which the world begins; 0 by default. */
    public WorldBuilder startTime(double startTime) {
        if (!Double.isFinite(startTime)) {
            throw new IllegalArgumentException("start time must be finite, but is " + startTime);
        }
        this.startTime = startTime;
        return this;
    }

    /**
     * The time (s) by which a step moves on if nothing shortens it; 0.05 s by default.
     *
     * @throws IllegalArgumentException if it is not positive and finite
     */
    public WorldBuilder timeStep(double timeStep) {
        World.requireTimeStep(timeStep);
        this.timeStep = timeStep;
        return this;
    }

    /** Where the world is on Earth; nowhere by default. */
    public WorldBuilder datum(Datum datum) {
        this.datum = Optional.of(datum);
        return this;
    }

    /** How a step is made; by an {@link EventStepper} by default. */
    public WorldBuilder stepper(Stepper stepper) {
        this.stepper = stepper;
        return this;
    }

    /** How the equations of motion are solved. */
    public WorldBuilder integrator(Integrator integrator) {
        this.integrator = integrator;
        return this;
    }

    /** What an object does in a collision that has no response of its own. */
    public WorldBuilder response(CollisionResponse response) {
        this.response = response;
        return this;
    }

    /** How volumes are found to touch. */
    public WorldBuilder queries(PairQueries queries) {
        this.queries = queries;
        return this;
    }

    /** Lets every object collide as its bounding sphere, as the thesis does (section 5.1.2). */
    public WorldBuilder asBoundingSpheres() {
        asBoundingSpheres = true;
        return this;
    }

    /** Lets objects overlap at the start; otherwise they must not. */
    public WorldBuilder allowOverlaps() {
        overlapsAllowed = true;
        return this;
    }

    /** Where the parts of a step run side by side; on the calling thread by default. */
    public WorldBuilder lanes(Lanes lanes) {
        this.lanes = lanes;
        return this;
    }

    /** Adds a field or another entity that is no body. */
    public WorldBuilder add(Entity entity) {
        entities.add(entity);
        return this;
    }

    /** Adds a world object. */
    public WorldBuilder add(WorldObjectDefinition object) {
        objects.add(object);
        return this;
    }

    /**
     * The world. Objects without an id get the lowest ones that nobody states, in order.
     *
     * @throws WorldException if an id or a name is used twice, if objects overlap that must not, if
     *     one that is to collide as its bounding sphere has none, or if an effect couples one to a
     *     body that is not in the world
     */
    public World build() {
        World world = new World(this);
        entities.forEach(world::add);
        // Those that state an id first, so that the others do not take it.
        objects.stream().filter(o -> o.id().isPresent()).forEach(world::enter);
        long free = 1;
        for (WorldObjectDefinition object : objects) {
            if (object.id().isEmpty()) {
                while (world.find(free).isPresent()) {
                    free++;
                }
                world.enter(object.withId(OptionalLong.of(free)));
            }
        }
        world.requirePartners();
        if (!overlapsAllowed) {
            world.requireApart();
        }
        return world;
    }
}
