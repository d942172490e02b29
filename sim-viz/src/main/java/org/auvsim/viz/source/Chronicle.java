package org.auvsim.viz.source;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.core.entity.Field;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.auvsim.viz.scene.Meeting;
import org.auvsim.viz.scene.Occurrence;
import org.auvsim.viz.scene.SeenObject;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** What a recording tells, by the world's time. It is written once, and then only read. */
final class Chronicle {
    private final List<Course> courses = new ArrayList<>();
    private final Map<Long, Course> newest = new HashMap<>();
    private final Timeline<Meeting> meetings = new Timeline<>();
    private final Timeline<Occurrence> occurrences = new Timeline<>();
    private final Timeline<List<Field<?>>> fields = new Timeline<>();
    private final Times steps = new Times();
    private long most;
    private long states;
    private int stride = 1;

    /** An empty one that keeps about so many states and steps at most. */
    Chronicle(long most) {
        this.most = most;
    }

    /** A scenario's world takes the place of what there was. */
    void install(Scenario scenario, int order) {
        World world = scenario.world();
        double time = world.time();
        newest.values().forEach(course -> course.end(time, order));
        newest.clear();
        for (WorldObject object : world.objects()) {
            begin(SeenObject.of(object.id(), object.presentDefinition()), time, order);
        }
        fields.add(time, order, world.fields());
        step(time);
    }

    /** An object has come at a time (s). */
    Course begin(SeenObject object, double time, int order) {
        end(object.id(), time, order);
        Course course = new Course(object, time, order);
        courses.add(course);
        newest.put(object.id(), course);
        count(course.track().times().count());
        return course;
    }

    /** An entity has gone at a time (s). */
    void end(long id, double time, int order) {
        course(id).ifPresent(course -> course.end(time, order));
        List<Field<?>> others = new ArrayList<>(fields.last(List.of()));
        if (others.removeIf(field -> field.id() == id)) {
            fields.add(time, order, List.copyOf(others));
        }
    }

    /** A field has come at a time (s). */
    void add(Field<?> field, double time, int order) {
        List<Field<?>> all = new ArrayList<>(fields.last(List.of()));
        if (all.stream().noneMatch(other -> other.id() == field.id())) {
            all.add(field);
            fields.add(time, order, List.copyOf(all));
        }
    }

    /** The object that has this id now. */
    Optional<Course> course(long id) {
        return Optional.ofNullable(newest.get(id)).filter(course -> !course.hasEnded());
    }

    /** What had this id when it was there last. */
    Optional<SeenObject> known(long id) {
        return Optional.ofNullable(newest.get(id)).map(Course::object);
    }

    /** An object, which stood still until {@code before} (s), is somewhere at a time (s). */
    void move(Course course, double before, double time, Vec3 place, Quat turn) {
        Times times = course.track().times();
        int known = times.count();
        if (time < times.newest()) {
            course.track().cut(time);
        }
        if (before < time) {
            course.track().rest(before);
        }
        course.track().add(time, place, turn);
        count(times.count() - known);
    }

    /** There was a step's end at a time (s). */
    void step(double time) {
        if (time < steps.newest()) {
            steps.cut(time);
        }
        int known = steps.count();
        steps.add(time);
        count(steps.count() - known);
    }

    private void count(int more) {
        states += more;
        if (states > most) {
            thin();
        }
    }

    private void thin() {
        stride *= 2;
        steps.thin();
        courses.forEach(course -> course.track().thin());
        recount();
        most = Math.max(most, 2 * states);
    }

    private void recount() {
        states = steps.count();
        courses.forEach(course -> states += course.track().times().count());
    }

    /** Forgets what lies after a cut. */
    void cut(Cut cut) {
        courses.removeIf(course -> course.cut(cut));
        newest.clear();
        courses.forEach(course -> newest.put(course.id(), course));
        Cut byTime = Cut.at(cut.time());
        meetings.cut(byTime);
        occurrences.cut(byTime);
        fields.cut(cut);
        steps.cut(cut.time());
        step(cut.time());
        recount();
    }

    List<Course> courses() {
        return courses;
    }

    Timeline<Meeting> meetings() {
        return meetings;
    }

    Timeline<Occurrence> occurrences() {
        return occurrences;
    }

    void tell(double time, int order, String sentence) {
        occurrences.add(time, order, new Occurrence(time, sentence));
    }

    /** What fills the world, each time all of it. */
    Timeline<List<Field<?>>> fields() {
        return fields;
    }

    /** The ends of steps, and the beginning. */
    Times steps() {
        return steps;
    }

    /** One of so many states is kept. */
    int stride() {
        return stride;
    }
}
