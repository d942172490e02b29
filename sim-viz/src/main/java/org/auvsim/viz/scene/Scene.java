package org.auvsim.viz.scene;

import org.auvsim.core.entity.Field;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * What there is to see. Sources write into it from their threads, renderers and windows look at it
 * from theirs; it keeps the newest state of each object and the one before, and a bounded trail, so
 * that neither side waits for the other for longer than one look takes.
 */
public final class Scene {
    /** So many collisions, and so many occurrences, are kept. */
    private static final int MOST_KEPT = 200;

    /**
     * So many objects leave a fine trail, some 30 MB of them; those that come then a coarse one.
     */
    private static final int MOST_FINE = 1000;

    private final SceneClock clock;
    private final Map<Long, Actor> byId = new HashMap<>();
    private final List<Actor> actors = new ArrayList<>();
    private final List<Meeting> meetings = new ArrayList<>();
    private final Deque<Occurrence> occurrences = new ArrayDeque<>();
    private final Worlds worlds = new Worlds();
    private final Look look = new Look();
    private List<Field<?>> fields = List.of();
    private Water water = Water.STILL;
    private long revision;
    private double time;

    /** An empty scene that shows the times of a clock. */
    public Scene(SceneClock clock) {
        this.clock = clock;
    }

    /** An object has come, or is known better. */
    public synchronized void add(SeenObject object) {
        Actor known = byId.get(object.id());
        if (known == null) {
            int remembered = actors.size() < MOST_FINE ? Trail.MOST : Trail.FEW;
            Actor actor = new Actor(object, time, remembered);
            byId.put(object.id(), actor);
            actors.add(actor);
            revision++;
        } else {
            revision += known.object().looksLike(object) ? 0 : 1;
            known.become(object);
        }
    }

    /** An object has gone. */
    public synchronized void remove(long id) {
        Actor gone = byId.remove(id);
        if (gone != null) {
            actors.remove(gone);
            revision++;
        }
    }

    /** What is not among these has gone. */
    public synchronized void keepOnly(Set<Long> ids) {
        for (SeenObject object : objects()) {
            if (!ids.contains(object.id())) {
                remove(object.id());
            }
        }
    }

    /** Everything has gone. */
    public synchronized void clear() {
        worlds.leave(objects());
        byId.clear();
        actors.clear();
        meetings.clear();
        fields = List.of();
        water = Water.STILL;
        revision++;
    }

    /** What is there may be another world by now, and will be told anew. */
    public synchronized void leaveWorld() {
        worlds.leave(objects());
    }

    /** All that there is has been told. */
    public synchronized void enterWorld() {
        worlds.enter(objects());
    }

    /** Counts up when another world has been told than the one before. */
    public synchronized long worlds() {
        return worlds.count();
    }

    /** An object has moved on; nothing happens if it is not known. */
    public synchronized void move(long id, Movement motion) {
        Actor actor = byId.get(id);
        if (actor != null) {
            actor.move(motion);
        }
    }

    /** An object is somewhere else all at once: nothing lies between. */
    public synchronized void jump(long id, Movement motion) {
        Actor actor = byId.get(id);
        if (actor != null) {
            actor.jump(motion);
        }
    }

    /** The step under way will bring an object here. */
    public synchronized void project(long id, Movement motion) {
        Actor actor = byId.get(id);
        if (actor != null) {
            actor.project(motion);
        }
    }

    /** A robot measured that an object is here (m, world). */
    public synchronized void measure(long id, double at, Vec3 position) {
        Actor actor = byId.get(id);
        if (actor != null) {
            actor.measure(at, position.x(), position.y(), position.z());
        }
    }

    /** These forces are set on an object. */
    public synchronized void setForces(long id, List<NamedForce> forces) {
        Actor actor = byId.get(id);
        if (actor != null) {
            actor.setForces(forces);
        }
    }

    /** These fields fill the world. */
    public synchronized void setFields(List<Field<?>> others) {
        fields = List.copyOf(others);
        water = Water.of(fields);
        revision++;
    }

    /** Two entities have met. */
    public synchronized void meet(Meeting meeting) {
        meetings.addFirst(meeting);
        if (meetings.size() > MOST_KEPT) {
            meetings.removeLast();
        }
    }

    /** Something happened that people want to read of. */
    public synchronized void tell(Occurrence occurrence) {
        occurrences.addLast(occurrence);
        if (occurrences.size() > MOST_KEPT) {
            occurrences.removeFirst();
        }
    }

    /** A step is done, now (ns of the machine's clock), that ends at {@code end} (s). */
    public synchronized void stepDone(double end, long nanos) {
        clock.stepDone(end, nanos);
    }

    /** Time has jumped to {@code to} (s): what is to come stands there at once. */
    public synchronized void jumpTo(double to) {
        clock.jump(to);
        time = to;
        meetings.clear();
    }

    /** What was told since the last call, in order. */
    public synchronized List<Occurrence> drainOccurrences() {
        List<Occurrence> all = List.copyOf(occurrences);
        occurrences.clear();
        return all;
    }

    /** Counts up whenever objects or fields come, go or look otherwise; not when they move. */
    public synchronized long revision() {
        return revision;
    }

    /** All objects, in order of their coming. */
    public synchronized List<SeenObject> objects() {
        return actors.stream().map(Actor::object).toList();
    }

    /** The object with an id. */
    public synchronized Optional<SeenObject> object(long id) {
        return Optional.ofNullable(byId.get(id)).map(Actor::object);
    }

    /** How an object moves at the time that is shown. */
    public synchronized Optional<Movement> motion(long id) {
        return Optional.ofNullable(byId.get(id)).map(this::motionOf);
    }

    private Movement motionOf(ActorView actor) {
        return new Movement(
                time,
                new Vec3(actor.position(0), actor.position(1), actor.position(2)),
                new Quat(
                        actor.orientation(0),
                        actor.orientation(1),
                        actor.orientation(2),
                        actor.orientation(3)),
                new Vec3(actor.velocity(0), actor.velocity(1), actor.velocity(2)),
                new Vec3(
                        actor.angularVelocity(0),
                        actor.angularVelocity(1),
                        actor.angularVelocity(2)));
    }

    /** How the water moves. */
    public synchronized Water water() {
        return water;
    }

    /** The world's time that was shown at the last look (s). */
    public synchronized double time() {
        return time;
    }

    /** Shows what there is at an instant of the machine's clock (ns). Makes nothing by itself. */
    public synchronized void look(long nanos, Consumer<SceneLook> viewer) {
        time = clock.at(nanos);
        for (int i = 0; i < actors.size(); i++) {
            actors.get(i).showAt(time);
        }
        viewer.accept(look);
    }

    /** Reads something of one object as it was shown last; empty if it is not known. */
    public synchronized <T> Optional<T> lookAt(long id, Function<ActorView, T> reading) {
        return Optional.ofNullable(byId.get(id)).map(reading);
    }

    private final class Look implements SceneLook {
        @Override
        public double time() {
            return time;
        }

        @Override
        public int count() {
            return actors.size();
        }

        @Override
        public ActorView actor(int i) {
            return actors.get(i);
        }

        @Override
        public List<Field<?>> fields() {
            return fields;
        }

        @Override
        public Water water() {
            return water;
        }

        @Override
        public List<Meeting> meetings() {
            return meetings;
        }
    }
}
