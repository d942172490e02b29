package org.auvsim.experiments.bench;

import org.auvsim.core.entity.BodyMotion;
import org.auvsim.core.entity.Contact;
import org.auvsim.core.entity.Participant;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.step.Collision;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The paths of all bodies of a world over its last step, as its state and its collisions tell them:
 * a cubic through positions and velocities from each knot to the next, where the knots are the
 * step's start, the body's collisions and the step's end.
 *
 * <p>Ids must be 1 to the number of bodies.
 */
final class StepPaths {
    /** A place (m) and the velocities (m/s) with which the body comes and goes. */
    private record Knot(double time, Vec3 place, Vec3 arriving, Vec3 leaving) {}

    private static final Comparator<Knot> BY_TIME = Comparator.comparingDouble(Knot::time);

    private final World world;
    private final List<List<Knot>> paths = new ArrayList<>();
    private final List<Knot> starts = new ArrayList<>();
    private double begin;
    private double end;

    /** Follows a world from now on. */
    StepPaths(World world) {
        this.world = world;
        this.begin = world.time();
        this.end = begin;
        for (WorldObject object : world.objects()) {
            paths.add(new ArrayList<>());
            starts.add(now(object));
        }
        world.addListener(this::hear);
    }

    private Knot now(WorldObject object) {
        return new Knot(world.time(), object.position(), object.velocity(), object.velocity());
    }

    private void hear(WorldEvent event) {
        if (event instanceof WorldEvent.Collided collided) {
            Collision collision = collided.collision();
            Contact contact = collision.contact();
            meet(contact.time(), contact.self(), collision.impulse());
            meet(contact.time(), contact.other(), collision.impulse().times(-1));
        }
    }

    private void meet(double time, Participant participant, Vec3 impulse) {
        BodyMotion before = participant.body().orElseThrow();
        List<Knot> path = paths.get((int) participant.id() - 1);
        Vec3 change = before.mobility().linear().times(impulse);
        Vec3 arriving = before.velocity();
        Vec3 place = before.state().position();
        if (isLast(path, time, arriving)) {
            // One of several contacts that were answered together: their impulses add up.
            Vec3 leaving = path.removeLast().leaving().plus(change);
            path.add(new Knot(time, place, arriving, leaving));
        } else {
            path.add(new Knot(time, place, arriving, arriving.plus(change)));
        }
    }

    private static boolean isLast(List<Knot> path, double time, Vec3 arriving) {
        return !path.isEmpty()
                && path.getLast().time() == time
                && path.getLast().arriving().equals(arriving);
    }

    /** Takes up the step that the world has just made. */
    void stepped() {
        end = world.time();
        List<WorldObject> objects = world.objects();
        for (int i = 0; i < paths.size(); i++) {
            List<Knot> path = paths.get(i);
            path.sort(BY_TIME);
            path.addFirst(starts.get(i));
            path.addLast(now(objects.get(i)));
        }
    }

    /** Forgets that step, to follow the next one. */
    void forget() {
        begin = end;
        for (int i = 0; i < paths.size(); i++) {
            starts.set(i, paths.get(i).getLast());
            paths.get(i).clear();
        }
    }

    /** How long the step is (s). */
    double length() {
        return end - begin;
    }

    /** Writes where all are (m) after a share of the step, 0 to 1: x, y, z at 3 i and behind. */
    void write(double share, double[] to) {
        double time = share == 1 ? end : begin + share * (end - begin);
        for (int i = 0; i < paths.size(); i++) {
            Vec3 place = at(paths.get(i), time);
            to[3 * i] = place.x();
            to[3 * i + 1] = place.y();
            to[3 * i + 2] = place.z();
        }
    }

    private static Vec3 at(List<Knot> path, double time) {
        int k = path.size() - 1;
        while (k > 0 && path.get(k).time() > time) {
            k--;
        }
        return k == path.size() - 1
                ? path.get(k).place()
                : cubic(path.get(k), path.get(k + 1), time);
    }

    /** The cubic Hermite polynomial between two knots. */
    private static Vec3 cubic(Knot from, Knot to, double time) {
        double h = to.time() - from.time();
        double s = (time - from.time()) / h;
        double r = 1 - s;
        return from.place()
                .times(r * r * (1 + 2 * s))
                .plus(to.place().times(s * s * (1 + 2 * r)))
                .plus(from.leaving().times(h * s * r * r))
                .minus(to.arriving().times(h * s * s * r));
    }
}
