package org.auvsim.viz.source;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.viz.scene.SeenObject;

import java.util.ArrayList;
import java.util.List;

/** All that a recording tells of one object, from its coming to its going. */
final class Course {
    /** So many commands decide what a propulsor with a lag does; those before have faded. */
    private static final int REMEMBERED = 8;

    private final SeenObject object;
    private final double from;
    private final int order;
    private final Track track = new Track();
    private final Timeline<List<NamedForce>> forces = new Timeline<>();
    private final Timeline<Vec3> marks = new Timeline<>();
    private final List<Levels> levels = new ArrayList<>();
    private double to = Double.POSITIVE_INFINITY;
    private int toOrder;

    /** What a propulsor was told. */
    private record Levels(String propulsor, Timeline<Double> told) {}

    /** The course of an object that came at a time (s), as entry {@code order} tells. */
    Course(SeenObject object, double from, int order) {
        this.object = object;
        this.from = from;
        this.order = order;
        object.definition().ifPresent(d -> track.add(from, d.position(), d.orientation()));
        forces.add(
                from,
                order,
                object.definition().map(WorldObjectDefinition::force).orElse(List.of()));
    }

    long id() {
        return object.id();
    }

    SeenObject object() {
        return object;
    }

    boolean isThere(double time) {
        return from <= time && time < to;
    }

    /** It has gone at a time (s). */
    void end(double time, int itsOrder) {
        if (to == Double.POSITIVE_INFINITY) {
            to = time;
            toOrder = itsOrder;
        }
    }

    boolean hasEnded() {
        return to < Double.POSITIVE_INFINITY;
    }

    /** Forgets what lies after a cut; returns whether nothing is left. */
    boolean cut(Cut cut) {
        if (cut.drops(from, order)) {
            return true;
        }
        if (cut.drops(to, toOrder)) {
            to = Double.POSITIVE_INFINITY;
        }
        track.cut(cut.time());
        forces.cut(cut);
        marks.cut(Cut.at(cut.time()));
        levels.forEach(one -> one.told().cut(cut));
        return false;
    }

    Track track() {
        return track;
    }

    /** The forces on it, each time all of them. */
    Timeline<List<NamedForce>> forces() {
        return forces;
    }

    /** Where it was measured to be (m, world). */
    Timeline<Vec3> marks() {
        return marks;
    }

    /** A force is set, in place of one of the same name. */
    void apply(double time, int itsOrder, NamedForce force) {
        List<NamedForce> others = without(force.name());
        others.add(force);
        forces.add(time, itsOrder, List.copyOf(others));
    }

    void removeForce(double time, int itsOrder, String name) {
        forces.add(time, itsOrder, List.copyOf(without(name)));
    }

    private List<NamedForce> without(String name) {
        List<NamedForce> others = new ArrayList<>(forces.last(List.of()));
        others.removeIf(force -> force.name().equals(name));
        return others;
    }

    /** A propulsor is told a level. */
    void tell(double time, int itsOrder, String propulsor, double level) {
        for (Levels one : levels) {
            if (one.propulsor().equals(propulsor)) {
                one.told().add(time, itsOrder, level);
                return;
            }
        }
        Levels first = new Levels(propulsor, new Timeline<>());
        first.told().add(time, itsOrder, level);
        levels.add(first);
    }

    /** How many levels its propulsors have been told until a time (s). */
    int toldUntil(double time) {
        int count = 0;
        for (int i = 0; i < levels.size(); i++) {
            count += levels.get(i).told().countUntil(time);
        }
        return count;
    }

    /** The object with its propulsors as they have been told until a time (s). */
    SeenObject objectAt(double time) {
        if (toldUntil(time) == 0 || object.definition().isEmpty()) {
            return object;
        }
        WorldObjectDefinition definition = object.definition().get();
        List<Component> components = new ArrayList<>(definition.component());
        components.replaceAll(c -> c instanceof Propulsor propulsor ? told(propulsor, time) : c);
        return SeenObject.of(object.id(), definition.toBuilder().components(components).build());
    }

    private Propulsor told(Propulsor propulsor, double time) {
        Propulsor told = propulsor;
        for (Levels one : levels) {
            if (one.propulsor().equals(propulsor.name())) {
                int count = one.told().countUntil(time);
                for (int i = Math.max(count - REMEMBERED, 0); i < count; i++) {
                    told = told.commanded(one.told().get(i), one.told().time(i));
                }
            }
        }
        return told;
    }
}
