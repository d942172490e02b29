package org.auvsim.core.world;

import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.sensor.Kinematics;

import java.util.Map;
import java.util.TreeMap;

/** How bodies move from the beginning of a part of a step to its end. */
final class Course {
    private final Population population;
    private final Map<Long, Kinematics> begins = new TreeMap<>();
    private double began;
    private double ends;

    Course(Population population) {
        this.population = population;
    }

    /** It begins, at a time (s). */
    void begin(double time) {
        began = time;
        begins.clear();
    }

    /**
     * Somebody will ask where an object was on the way; others can only be asked for at the end.
     */
    void keep(WorldObject object) {
        if (!object.isFixed() && !begins.containsKey(object.id())) {
            begins.put(object.id(), Kinematics.of(object, began));
        }
    }

    /** The same for all objects. */
    void keepAll() {
        population.objects().forEach(this::keep);
    }

    /** It ends, at a time (s), that of the bodies' present states. */
    void end(double time) {
        ends = time;
    }

    /** How an object moves at a time (s) of the course. */
    Kinematics at(WorldObject object, double time) {
        Kinematics end = Kinematics.of(object, ends);
        Kinematics begin = begins.get(object.id());
        return begin == null || !(time < ends) || !(began < ends) ? end : begin.toward(end, time);
    }
}
