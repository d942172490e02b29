package org.auvsim.diagnosis.online;

import org.auvsim.core.entity.Actuator;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.world.World;
import org.auvsim.server.feedback.AppliedFeedback;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Predicate;

/**
 * Sees what an object is told and what is measured of it. Where that could not be heard, all is
 * left out until the break itself can be, and then commands are told anew. Belongs to the
 * simulation thread.
 */
final class Watcher {
    /** A step that ends so much later (in steps) than it may was preceded by a jump. */
    private static final double LONGEST = 1.5;

    private final long objectId;
    private final Predicate<Observation> hears;
    private final List<Observation> measured = new ArrayList<>();
    private SortedMap<String, Double> told = new TreeMap<>();
    private OptionalDouble now = OptionalDouble.empty();
    private boolean isBroken;

    /**
     * Sees an object.
     *
     * @param hears is told of it, and whether that was heard
     */
    Watcher(long objectId, Predicate<Observation> hears) {
        this.objectId = objectId;
        this.hears = hears;
    }

    void corrected(AppliedFeedback applied) {
        measured.add(new Observation.Measured(applied.time(), applied.target()));
    }

    /** What was told was told before the step; what was measured, at its end. */
    void stepMade(World world) {
        if (now.isPresent() && hasJumped(now.getAsDouble(), world)) {
            isBroken = true;
            now = OptionalDouble.empty();
        }
        if (isBroken) {
            told = new TreeMap<>();
            isBroken = !hears.test(new Observation.Broken());
        }
        if (now.isPresent() && world.find(objectId).isPresent()) {
            tell(now.getAsDouble(), world.object(objectId));
        }
        measured.forEach(this::tell);
        measured.clear();
        now = OptionalDouble.of(world.time());
    }

    private static boolean hasJumped(double before, World world) {
        double elapsed = world.time() - before;
        return elapsed < 0 || elapsed > LONGEST * world.timeStep();
    }

    private void tell(double from, WorldObject object) {
        SortedMap<String, Double> levels = levels(object);
        if (!levels.equals(told)) {
            told = levels;
            tell(new Observation.Told(from, levels, object.forces()));
        }
    }

    private void tell(Observation observation) {
        isBroken = isBroken || !hears.test(observation);
    }

    private static SortedMap<String, Double> levels(WorldObject object) {
        SortedMap<String, Double> levels = new TreeMap<>();
        for (Actuator actuator : object.actuators()) {
            levels.put(actuator.name(), actuator.command());
        }
        for (NamedForce force : object.forces()) {
            levels.put(force.name() + ".x", force.vector().x());
            levels.put(force.name() + ".y", force.vector().y());
            levels.put(force.name() + ".z", force.vector().z());
        }
        return levels;
    }
}
