package org.auvsim.auvsml.document;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.dynamics.Integrator;
import org.auvsim.core.dynamics.Rk4;
import org.auvsim.core.entity.Field;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.sensor.Datum;
import org.auvsim.core.step.EventStepper;
import org.auvsim.core.step.Lanes;
import org.auvsim.core.step.Stepper;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;

import java.util.List;
import java.util.Optional;

/**
 * A world and how it is to be run, as a file states it.
 *
 * @param startTime the world's time at the beginning
 * @param boundingSpheres whether objects collide as their bounding spheres (thesis, section 5.1.2)
 * @param allowOverlaps whether objects may overlap at the beginning
 * @param feedbackHorizon how far back feedback may be true that comes late; the steps since then
 *     are made again with it
 * @param timeStep by how much a step moves time on
 * @param stepper how a step is made
 * @param integrator how the equations of motion are solved over it
 * @param feedbackTimestepping when robots' feedback is taken
 * @param feedbackProcessor which processor uses it; empty: the one that each message names
 * @param releasedObject what becomes of objects that clients let go; empty: all goes on
 * @param datum where the world is on Earth; needed by sensors that tell that
 * @param field what fills the whole world: currents, magnetic fields, temperatures
 * @param worldObject what moves, or does not
 */
public record Scenario(
        @Unit("s") @Default("0.0") double startTime,
        @Default("0") boolean boundingSpheres,
        @Default("0") boolean allowOverlaps,
        @Unit("s") @Default("0.0") double feedbackHorizon,
        @Default("0.05") TimeStep timeStep,
        @Default("event-stepper") Stepper stepper,
        @Default("rk4") Integrator integrator,
        @Default("asynchronous-feedback-timestepper") FeedbackTimestepping feedbackTimestepping,
        Optional<FeedbackProcessorChoice> feedbackProcessor,
        Optional<ReleasedObject> releasedObject,
        Optional<Datum> datum,
        List<Field<?>> field,
        List<WorldObjectDefinition> worldObject) {
    /**
     * A checked scenario.
     *
     * @throws IllegalArgumentException if a time step is lost in the start time's rounding
     */
    public Scenario {
        if (startTime + timeStep.delta() == startTime) {
            throw new IllegalArgumentException(
                    "a time step of %s s leaves the start time of %s s as it is; begin earlier, or"
                                    .formatted(timeStep.delta(), startTime)
                            + " take a longer step");
        }
        if (!(feedbackHorizon >= 0)) {
            throw new IllegalArgumentException(
                    "the feedback horizon must be 0 s or more, but is %s s"
                            .formatted(feedbackHorizon));
        }
        field = List.copyOf(field);
        worldObject = List.copyOf(worldObject);
    }

    /** A world as it is now, as the beginning of a scenario; all else as by default. */
    public static Scenario of(World world) {
        return new Scenario(
                world.time(),
                /* boundingSpheres= */ false,
                /* allowOverlaps= */ true,
                /* feedbackHorizon= */ 0,
                new TimeStep(world.timeStep()),
                new EventStepper(),
                new Rk4(),
                new FeedbackTimestepping.AsynchronousFeedbackTimestepper(),
                Optional.empty(),
                Optional.empty(),
                world.datum(),
                world.fields(),
                world.objects().stream().map(WorldObject::presentDefinition).toList());
    }

    /**
     * The world at the beginning.
     *
     * @throws org.auvsim.core.world.WorldException if an id or a name is used twice, if objects
     *     overlap that may not, or if one that is to collide as its bounding sphere has none
     */
    public World world() {
        return world(Lanes.ONE);
    }

    /** The same, its steps made on these lanes. */
    public World world(Lanes lanes) {
        return world(lanes, allowOverlaps);
    }

    /** The same, overlaps allowed or not whatever is stated. */
    World world(Lanes lanes, boolean overlapsAllowed) {
        WorldBuilder world =
                World.builder()
                        .startTime(startTime)
                        .timeStep(timeStep.delta())
                        .stepper(stepper)
                        .integrator(integrator)
                        .lanes(lanes);
        if (boundingSpheres) {
            world.asBoundingSpheres();
        }
        if (overlapsAllowed) {
            world.allowOverlaps();
        }
        datum.ifPresent(world::datum);
        field.forEach(world::add);
        worldObject.forEach(world::add);
        return world.build();
    }

    /** Sentences on what it states and what does not hold to the letter. */
    public List<String> notices() {
        return worldObject.stream()
                .flatMap(
                        object ->
                                object.addedMass().stream()
                                        .flatMap(added -> added.notices().stream())
                                        .map(("'" + object.name() + "': ")::concat))
                .toList();
    }

    /** The same scenario with other fields. */
    Scenario withFields(List<Field<?>> fields) {
        return with(fields, worldObject);
    }

    /** The same scenario with another time step. */
    public Scenario with(TimeStep other) {
        return new Scenario(
                startTime,
                boundingSpheres,
                allowOverlaps,
                feedbackHorizon,
                other,
                stepper,
                integrator,
                feedbackTimestepping,
                feedbackProcessor,
                releasedObject,
                datum,
                field,
                worldObject);
    }

    /** The same scenario with another time (s) at the beginning. */
    public Scenario beginningAt(double time) {
        return new Scenario(
                time,
                boundingSpheres,
                allowOverlaps,
                feedbackHorizon,
                timeStep,
                stepper,
                integrator,
                feedbackTimestepping,
                feedbackProcessor,
                releasedObject,
                datum,
                field,
                worldObject);
    }

    /** The same scenario with other fields and objects. */
    public Scenario with(List<Field<?>> fields, List<WorldObjectDefinition> worldObjects) {
        return new Scenario(
                startTime,
                boundingSpheres,
                allowOverlaps,
                feedbackHorizon,
                timeStep,
                stepper,
                integrator,
                feedbackTimestepping,
                feedbackProcessor,
                releasedObject,
                datum,
                fields,
                worldObjects);
    }

    /**
     * The same scenario with a world's present time and objects as its beginning. Overlaps that the
     * world has come to, as it may in heaps, are let be.
     */
    public Scenario resumedFrom(World world) {
        return new Scenario(
                world.time(),
                boundingSpheres,
                /* allowOverlaps= */ true,
                feedbackHorizon,
                timeStep,
                stepper,
                integrator,
                feedbackTimestepping,
                feedbackProcessor,
                releasedObject,
                datum,
                world.fields(),
                world.objects().stream().map(WorldObject::presentDefinition).toList());
    }
}
