package org.auvsim.diagnosis.online;

import org.auvsim.auvsml.message.feedback.FeedbackMessage;
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
import java.util.function.Consumer;

/** Sees what an object is told and what is measured of it. Belongs to the simulation thread. */
final class Watcher {
    /** A step that ends so much later (in steps) than it may was preceded by a jump. */
    private static final double LONGEST = 1.5;

    private final long objectId;
    private final Consumer<Observation> tell;
    private final List<Observation> measured = new ArrayList<>();
    private SortedMap<String, Double> told = new TreeMap<>();
    private OptionalDouble now = OptionalDouble.empty();

    Watcher(long objectId, Consumer<Observation> tell) {
        this.objectId = objectId;
        this.tell = tell;
    }

    void corrected(FeedbackMessage feedback, AppliedFeedback applied) {
        measured.add(new Observation.Measured(applied.time(), feedback, applied.target()));
    }

    /** What was told was told before the step; what was measured, at its end. */
    void stepMade(World world) {
        if (now.isPresent() && hasJumped(now.getAsDouble(), world)) {
            tell.accept(new Observation.Jumped());
            told = new TreeMap<>();
            now = OptionalDouble.empty();
        }
        if (now.isPresent() && world.find(objectId).isPresent()) {
            tell(now.getAsDouble(), world.object(objectId));
        }
        measured.forEach(tell);
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
            tell.accept(new Observation.Told(from, levels, object.forces()));
        }
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
