package org.auvsim.core.world;

import org.auvsim.core.communication.Transceiver;
import org.auvsim.core.communication.Transmission;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Entity;
import org.auvsim.core.entity.Field;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.entity.Wrench;
import org.auvsim.core.sensor.Datum;
import org.auvsim.core.step.Motion;
import org.auvsim.core.step.Overlap;
import org.auvsim.core.step.StepException;
import org.auvsim.core.step.StepResult;
import org.auvsim.core.step.StepStatistics;
import org.auvsim.core.step.Stepper;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;

/**
 * A simulated world: its entities, its time, and the one way in which time moves on.
 *
 * <p>A world belongs to one thread. It is deterministic: equal worlds that are treated equally stay
 * equal, bit for bit.
 */
public final class World {
    private final Announcements announcements = new Announcements();
    private Stepper stepper;
    private double timeStep;
    private Clock clock;
    private Population population;
    private Mechanics mechanics;
    private Consequences consequences;
    private Sensing sensing;
    private Optional<Datum> datum;
    private StepNews news;
    private Standstill standstill;

    World(WorldBuilder builder) {
        stepper = builder.stepper;
        timeStep = builder.timeStep;
        clock = new Clock(builder.startTime);
        population = new Population();
        population.bodies().state().setTime(time());
        mechanics = new Mechanics(builder, population);
        consequences = new Consequences(this, population, mechanics, announcements);
        datum = builder.datum;
        sensing = new Sensing(population, datum, announcements);
        news = new StepNews(population, mechanics.tally(), announcements);
        standstill = new Standstill();
    }

    private World(World original) {
        become(original);
    }

    private void become(World other) {
        stepper = other.stepper;
        timeStep = other.timeStep;
        clock = new Clock(other.clock);
        population = new Population(other.population);
        mechanics = new Mechanics(other.mechanics, population);
        consequences = new Consequences(this, population, mechanics, announcements);
        datum = other.datum;
        sensing = new Sensing(other.sensing, population, announcements);
        news = new StepNews(population, mechanics.tally(), announcements);
        standstill = new Standstill(other.standstill);
    }

    /** Starts to build a world. */
    public static WorldBuilder builder() {
        return new WorldBuilder();
    }

    /**
     * An independent copy, equal bit for bit, without listeners: a projected state, for example.
     */
    public World copy() {
        return new World(this);
    }

    /**
     * Becomes as another world is, bit for bit, time included: a copy of itself that was taken
     * before, for example. Its listeners stay, and are told nothing; objects that were asked for
     * before belong to it no longer. Ids that it has given are not given again.
     */
    public void restore(World other) {
        long nextId = population.nextId();
        become(other);
        population.reserve(nextId);
    }

    /** World time (s). */
    public double time() {
        return clock.time();
    }

    /** The time (s) by which a step moves on if nothing shortens it. */
    public double timeStep() {
        return timeStep;
    }

    static void requireTimeStep(double timeStep) {
        if (!(timeStep > 0) || Double.isInfinite(timeStep)) {
            throw new IllegalArgumentException(
                    "the time step must be above 0 s and finite, but is " + timeStep + " s");
        }
    }

    /** What the steps have done since the world was built. */
    public StepStatistics statistics() {
        return mechanics.tally().statistics();
    }

    /** A digest of time and state: worlds of equal bits have equal hashes. */
    public long stateHash() {
        return StateHash.of(time(), objects(), population.bodies().state());
    }

    /** All entities, in order of id; a view. */
    public Collection<Entity> entities() {
        return population.entities();
    }

    /** All world objects, in order of id. */
    public List<WorldObject> objects() {
        return population.objects();
    }

    /** All fields, in order of id. */
    public List<Field<?>> fields() {
        return population.bodies().state().fields();
    }

    /** The entity with an id. */
    public Optional<Entity> find(long id) {
        return population.find(id);
    }

    /**
     * The world object with an id.
     *
     * @throws WorldException if there is none
     */
    public WorldObject object(long id) {
        return population.object(id);
    }

    /**
     * The world object with a name.
     *
     * @throws WorldException if there is none
     */
    public WorldObject object(String name) {
        return population.object(name);
    }

    /**
     * Adds a world object, with the id that it states or the next free one.
     *
     * @throws WorldException if its id or name is taken, if it is to collide as its bounding sphere
     *     and has none, or if an effect couples it to a body that is not in the world
     */
    public WorldObject add(WorldObjectDefinition definition) {
        population.requirePartners(definition.name(), definition.effect());
        return enter(definition);
    }

    /** Checks what objects that entered before their partners say of these. */
    void requirePartners() {
        for (WorldObject object : objects()) {
            population.requirePartners(object.name(), object.effects());
        }
    }

    /** As {@link #add(WorldObjectDefinition)}, but its partners may follow. */
    WorldObject enter(WorldObjectDefinition definition) {
        mechanics.requireBounds(definition);
        sensing.requireFit(definition);
        WorldObject object = population.add(definition);
        entered(object.id());
        announcements.announce(new WorldEvent.ObjectAdded(time(), object.id(), object.position()));
        return object;
    }

    /**
     * Adds an entity that is no rigid body.
     *
     * @throws WorldException if its id or name is taken
     */
    public void add(Entity entity) {
        population.add(entity);
        entered(entity.id());
    }

    private void entered(long id) {
        mechanics.entered();
        announcements.announce(new WorldEvent.EntityAdded(time(), id));
    }

    /**
     * Gives the world object of a definition's name the mass properties, the volume, the effects
     * and the components that the definition states. How it moves, the forces on it and what its
     * actuators are told stay, and so does all that couples others to it.
     *
     * @return the object; what was asked for before belongs to the world no longer
     * @throws WorldException if there is no object of this name, or it could not be added so
     */
    public WorldObject revise(WorldObjectDefinition definition) {
        WorldObject former = object(definition.name());
        population.requirePartners(definition.name(), definition.effect());
        mechanics.requireBounds(definition);
        sensing.requireFit(definition);
        WorldObject revised = population.remake(former, definition.goingOnAs(former, time()));
        mechanics.left();
        return revised;
    }

    /**
     * Lets an effect act on a world object from now on.
     *
     * @throws WorldException if there is no such object, or the effect couples it to a body that is
     *     not in the world
     */
    public void addEffect(long objectId, Effect effect) {
        WorldObject object = object(objectId);
        population.requirePartners(object.name(), List.of(effect));
        population.bodies().addEffect(object, effect);
        mechanics.changed();
    }

    /**
     * Ends an effect on a world object; the first of equal ones.
     *
     * @return false if it has no such effect
     * @throws WorldException if there is no such object
     */
    public boolean removeEffect(long objectId, Effect effect) {
        boolean removed = population.bodies().removeEffect(object(objectId), effect);
        mechanics.changed();
        return removed;
    }

    /**
     * Removes an entity; its id is not used again. Effects that couple others to it end.
     *
     * @throws WorldException if there is none with this id
     */
    public void remove(long id) {
        population.remove(id);
        mechanics.left();
        announcements.announce(new WorldEvent.EntityRemoved(time(), id));
    }

    /**
     * Sends a message from a transceiver of an object. It travels as a {@link Transmission}, and
     * {@link WorldEvent.SignalReceived} tells whom it reaches; sent from where the transceiver does
     * not work, as from a radio under water, it reaches nobody.
     *
     * @param kind of the transceiver
     * @throws WorldException if there is no such object
     * @throws IllegalArgumentException if it has no such transceiver
     */
    public void transmit(
            long objectId, Class<? extends Transceiver> kind, String transceiver, String text) {
        Transmission.from(object(objectId), kind, transceiver, text, population.nextId(), time())
                .ifPresent(this::add);
    }

    /**
     * Nothing if no bodies that would collide overlap by more than rounding.
     *
     * @throws WorldException naming them
     */
    void requireApart() {
        mechanics.requireApart(time());
    }

    /** Where the world is on Earth. */
    public Optional<Datum> datum() {
        return datum;
    }

    /** Adds a listener, which hears of everything from now on. */
    public void addListener(WorldListener listener) {
        announcements.add(listener);
    }

    /** Removes a listener. */
    public void removeListener(WorldListener listener) {
        announcements.remove(listener);
    }

    /**
     * Moves time on by one step: behaviors act, bodies move to the end of the step or to the
     * earliest collision, what collides responds, listeners hear of it.
     *
     * @return by how much time has moved (s); 0 if bodies that touched already have responded
     * @throws StepException if the step cannot be made; the world is then as it was, but for what
     *     behaviors have set
     * @throws WorldException if collisions at one instant never end
     */
    public double advanceTimestep() {
        return advanceTimestep(timeStep);
    }

    /** As {@link #advanceTimestep()}, but for a step of at most {@code wanted} (s). */
    public double advanceTimestep(double wanted) {
        letBehaviorsAct();
        return continueTimestep(wanted);
    }

    /**
     * Goes on within a step that {@link #advanceTimestep(double)} has begun, so that forces may
     * change in the middle of it: the same as a step, but behaviors do not act again.
     */
    public double continueTimestep(double wanted) {
        requireTimeStep(wanted);
        announcements.hold();
        try {
            return step(wanted);
        } finally {
            announcements.release();
        }
    }

    private double step(double wanted) {
        news.stepBegins();
        double elapsed = 0;
        boolean goesOn = true;
        while (goesOn) {
            StepResult result = part(wanted - elapsed);
            elapsed += result.elapsed();
            goesOn = result.isInterrupted() && elapsed < wanted;
        }
        news.stepDone(time(), elapsed);
        return elapsed;
    }

    /** A step, or as much of it as can be made before the world has to change. */
    private StepResult part(double wanted) {
        Motion path = mechanics.motion(time());
        path.setHeard(!announcements.isUnheard());
        sensing.begin(time(), wanted);
        StepResult result = stepper.advance(path, wanted);
        moveTime(result.elapsed());
        standstill.guard(time(), result);
        news.collisions(result);
        sensing.measureUntil(time());
        // By index here and below: iterators would be garbage in each step.
        for (int k = 0; k < result.changes().size(); k++) {
            consequences.apply(result.changes().get(k));
        }
        removeWhatIsOver();
        return result;
    }

    private void moveTime(double elapsed) {
        clock.advance(elapsed);
        population.bodies().state().setTime(time());
    }

    private void letBehaviorsAct() {
        List<WorldObject> objects = population.bodies().active();
        // By index: an iterator an object would be garbage an object a step.
        for (int k = 0; k < objects.size(); k++) {
            WorldObject object = objects.get(k);
            List<Behavior> behaviors = object.behaviors();
            for (int i = 0; i < behaviors.size(); i++) {
                behaviors.get(i).act(time(), object);
            }
        }
    }

    private void removeWhatIsOver() {
        if (population.others().isEmpty()) {
            return;
        }
        List<Long> over = new ArrayList<>();
        for (Entity entity : population.others()) {
            if (entity.isOver(time())) {
                over.add(entity.id());
            }
        }
        over.forEach(this::remove);
    }

    /**
     * The pairs of world objects that share space now by more than rounding and would collide, in
     * order of their ids; of very many only some.
     */
    public List<Overlap> overlaps() {
        return mechanics.motion(time()).overlaps();
    }

    /**
     * The ids of the collidables that share space with an object now, in order: what a correction
     * of its position may have caused.
     *
     * @throws WorldException if there is no such object
     */
    public List<Long> overlaps(long objectId) {
        object(objectId);
        return mechanics.motion(time()).overlaps(objectId);
    }

    /**
     * What a mount exerts on a body in its present state, so that its momenta along the held
     * directions stay zero: the load on a towing carriage, a pivot or, with the opposite sign, on
     * what carries them. Of a fixed body it is what keeps it there, of a free one it is zero. What
     * bodies in contact add is not in it.
     *
     * @throws WorldException if there is no such object
     */
    public Wrench constraintForce(long objectId) {
        int slot = object(objectId).slot();
        return mechanics.motion(time()).constraintForce(slot);
    }
}
