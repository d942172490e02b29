package org.auvsim.core.step;

import org.auvsim.core.dynamics.ConstraintForce;
import org.auvsim.core.dynamics.Diagnosis;
import org.auvsim.core.dynamics.EquationsOfMotion;
import org.auvsim.core.dynamics.Integrator;
import org.auvsim.core.entity.Bodies;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.Collidable;
import org.auvsim.core.entity.CollisionResponse;
import org.auvsim.core.entity.Contact;
import org.auvsim.core.entity.RigidBody;
import org.auvsim.core.entity.Wrench;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.ContactPoint;
import org.auvsim.core.volume.PairQueries;
import org.auvsim.core.volume.Pose;
import org.auvsim.core.volume.Volume;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * How all collidables of a world would move on from the present snapshot: what the stages of a step
 * ask.
 *
 * <p>Collidables are numbered 0 to {@code size() - 1} in order of id. Instants are given as an
 * offset (s, 0 or more) from the snapshot. A body's future comes from the real integration of its
 * equations of motion (thesis, section 5.1.1: projectNewPosition); other collidables tell it
 * themselves. Nothing changes before {@link #commit}.
 */
public final class Motion {
    /** Bodies that approach slower than this (m/s) do so by rounding only. */
    private static final double APPROACH_TOLERANCE = 1e-10;

    /** The number of bodies from which lanes are used. */
    private static final int LANES_PAY = 512;

    /** Operations of a query, counted once by hand, for spheres. */
    private static final int DISPLACEMENT = 13;

    private static final int OVERLAP = 13;
    private static final int APPROACHING = 80;

    private final Collidables collidables;
    private final boolean asBoundingSpheres;
    private final BodyState bodies;
    private final PairQueries queries;
    private final CollisionResponse fallback;
    private final Bodies population;
    private final EquationsOfMotion equations;
    private final Integrator integrator;
    private final Lanes lanes;
    private final StepTally tally;
    private final ContactMemory memory;
    private Optional<Frame> frame = Optional.empty();
    private boolean isHeard;
    private final CollisionSets sets;
    private final Outlook outlook;
    private final Snapshot kept;
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();
    private double time;
    private long operations;

    /**
     * The motion of these collidables, in order of id; all bodies among them are in {@code bodies}.
     *
     * @param fallback the response of what has none of its own
     */
    public Motion(
            Bodies bodies,
            List<Collidable> collidables,
            EquationsOfMotion equations,
            Integrator integrator,
            PairQueries queries,
            CollisionResponse fallback,
            boolean asBoundingSpheres,
            Lanes lanes,
            StepTally tally,
            ContactMemory memory,
            double time) {
        this.population = bodies;
        this.equations = equations;
        this.integrator = integrator;
        this.asBoundingSpheres = asBoundingSpheres;
        this.lanes = lanes;
        this.tally = tally;
        this.memory = memory;
        this.bodies = bodies.state();
        this.collidables = new Collidables(collidables, fallback, asBoundingSpheres);
        this.queries = queries;
        this.fallback = fallback;
        this.time = time;
        sets = new CollisionSets(this);
        outlook = new Outlook(bodies, equations, integrator);
        kept = new Snapshot(this.bodies);
    }

    /** Begins a step from the bodies' present state, at the world's {@code time} (s). */
    public void begin(double time) {
        this.time = time;
        bodies.setTime(time);
        outlook.begin(time);
    }

    /** Whether somebody wants to be told of each collision. */
    public void setHeard(boolean heard) {
        isHeard = heard;
    }

    boolean isHeard() {
        return isHeard;
    }

    /** Where to run side by side; for few bodies the handing over costs more than it saves. */
    Lanes lanes() {
        return bodies.count() < LANES_PAY ? Lanes.ONE : lanes;
    }

    StepTally tally() {
        return tally;
    }

    ContactMemory memory() {
        return memory;
    }

    PairQueries queries() {
        return queries;
    }

    BodyState bodies() {
        return bodies;
    }

    /** What the event stepper works with, made when it is first asked for. */
    Frame frame() {
        if (frame.isEmpty()) {
            BodyTraits traits = traits();
            traits.rank(collidables);
            Trajectories trajectories =
                    new Trajectories(bodies, traits, equations, integrator, lanes());
            frame = Optional.of(new Frame(this, traits, trajectories, collidables.slots()));
        }
        return frame.get();
    }

    private BodyTraits traits() {
        return new BodyTraits(bodies, population.objects(), fallback, asBoundingSpheres);
    }

    /** Number of collidables. */
    public int size() {
        return collidables.size();
    }

    /** Collidable {@code i}; a body tells its present state, not the one at an offset. */
    public Collidable collidable(int i) {
        return collidables.get(i);
    }

    /**
     * Primitive operations (assignments and arithmetic, as the thesis' section 8.2 counts them) of
     * the queries asked so far and of the stages that tell theirs. Integration is not among them.
     */
    public long operations() {
        return operations;
    }

    /** Counts operations of a stage. */
    void count(long done) {
        operations += done;
    }

    /** The collision sets of the step. */
    CollisionSets sets() {
        return sets;
    }

    /** What collidable {@code i} does in a collision. */
    CollisionResponse response(int i) {
        return collidables.response(i);
    }

    /** The world's time (s) of the snapshot. */
    public double time() {
        return time;
    }

    /** Radius (m) of the bounding sphere at an offset. */
    public double radius(int i, double offset) {
        return collidables.isBody(i)
                ? bodies.radius()[collidables.slot(i)]
                : collidables.get(i).volumeAt(time + offset).boundingRadius();
    }

    /** Position (m, world) at an offset. */
    public Vec3 position(int i, double offset) {
        pose(i, offset, poseA);
        return poseA.position();
    }

    /** How far (m) it is from where it is now, at an offset. */
    public double displacement(int i, double offset) {
        count(DISPLACEMENT);
        Projection there = outlook.atEnd(offset);
        if (collidables.isBody(i)) {
            there.integrateAhead(collidables.slot(i));
        }
        pose(i, 0, poseA);
        pose(i, offset, poseB);
        return SweptSphere.distance(poseA, poseB);
    }

    /**
     * Writes the smallest sphere that holds the bounding spheres now and at {@code offset} (thesis,
     * section 5.1.2): x, y, z, radius at {@code to[4 * i]} and behind.
     */
    public void sweptSphere(int i, double offset, double[] to) {
        outlook.allAtEnd(offset);
        pose(i, 0, poseA);
        pose(i, offset, poseB);
        SweptSphere.write(poseA, radius(i, 0), poseB, radius(i, offset), to, 4 * i);
    }

    /** Whether a meeting of the two would be a collision at all. */
    public boolean mayCollide(int i, int j) {
        return collidables.mayCollide(i, j);
    }

    /**
     * Integrates the bodies of all pairs to an offset, together: cheaper than one after the other,
     * as {@link #overlap} would.
     */
    public void lookAhead(CollisionSets pairs, double offset) {
        Projection there = outlook.at(offset);
        for (int k = 0; k < pairs.pairCount(); k++) {
            want(pairs.first(k), there);
            want(pairs.second(k), there);
        }
        there.integrateWanted();
    }

    private void want(int i, Projection there) {
        if (collidables.isBody(i)) {
            there.want(collidables.slot(i));
        }
    }

    /** Whether the two volumes share a point at an offset. */
    public boolean overlap(int i, int j, double offset) {
        count(OVERLAP);
        if (offset != 0) {
            Projection there = outlook.at(offset);
            want(i, there);
            want(j, there);
            there.integrateWanted();
        }
        pose(i, offset, poseA);
        pose(j, offset, poseB);
        return queries.overlap(volume(i, offset), poseA, volume(j, offset), poseB);
    }

    /**
     * Whether two that touch at an offset move toward each other there; what is no body, such as a
     * wave, approaches everything.
     */
    public boolean approaching(int i, int j, double offset) {
        count(APPROACHING);
        if (!collidables.isBody(i) || !collidables.isBody(j)) {
            return true;
        }
        pose(i, offset, poseA);
        pose(j, offset, poseB);
        ContactPoint contact = queries.contact(volume(i, offset), poseA, volume(j, offset), poseB);
        Vec3 point = contact.point();
        Vec3 relative =
                outlook.velocityAt(collidables.body(i), point, offset)
                        .minus(outlook.velocityAt(collidables.body(j), point, offset));
        return contact.normal().dot(relative) < -APPROACH_TOLERANCE;
    }

    /**
     * Moves the world to an offset: the snapshot is now there.
     *
     * @throws StepException if a body would get a number that is not finite; nothing has moved then
     */
    public void commit(double offset) {
        if (offset > 0) {
            Projection there = outlook.allAtEnd(offset);
            requireFinite(there.anyNotFinite(), offset);
            tally.subSteps += there.subSteps();
            there.commit();
            begin(time + offset);
        }
    }

    /** Keeps the present snapshot for {@link #goBack}. */
    void keep() {
        kept.take(time);
    }

    /** Undoes what has happened to the bodies since {@link #keep}. */
    void goBack() {
        begin(kept.restore());
    }

    /** The error for two that collide without end. */
    StepException endless(int a, int b, long events, double offset) {
        return StepException.endless(
                collidables.get(a).name(), collidables.get(b).name(), events, time + offset);
    }

    /**
     * Nothing if {@code slot} is -1.
     *
     * @throws StepException naming the body in the slot, whose forces are too stiff for the step
     */
    void requireMild(int slot, double offset) {
        if (slot >= 0) {
            throw StepException.tooStiff(population.objects().get(slot).name(), time, offset);
        }
    }

    /**
     * Nothing if {@code slot} is -1.
     *
     * @throws StepException naming the body in the slot, whose motion is not finite
     */
    void requireFinite(int slot, double offset) {
        if (slot >= 0) {
            RigidBody body = population.objects().get(slot);
            String culprit =
                    new Diagnosis(
                                    equations,
                                    bodies,
                                    population.objects(),
                                    population.surroundings(),
                                    body)
                            .culprit(time, offset);
            throw StepException.runaway(body, time, offset, culprit);
        }
    }

    /** By what the body in a slot is held at present. */
    public Wrench constraintForce(int slot) {
        return new ConstraintForce(equations, bodies).on(slot, time);
    }

    /** The contact of two that touch now, as {@code i} sees it. */
    public Contact contact(int i, int j) {
        return contact(i, j, time);
    }

    /**
     * The contact of two that touch in their present states, which are those of {@code when} (s).
     */
    Contact contact(int i, int j, double when) {
        pose(i, 0, poseA);
        pose(j, 0, poseB);
        ContactPoint point = queries.contact(volume(i, 0), poseA, volume(j, 0), poseB);
        return new Contact(
                when,
                point.point(),
                point.normal(),
                collidables.participant(i),
                collidables.participant(j));
    }

    /** The ids of what shares space now with the collidable of an id, in order. */
    public List<Long> overlaps(long id) {
        List<Long> found = new ArrayList<>();
        int self = collidables.indexOf(id);
        for (int i = 0; i < size(); i++) {
            if (i != self && mayCollide(self, i) && overlap(self, i, 0)) {
                found.add(collidables.get(i).id());
            }
        }
        return found;
    }

    /**
     * The pairs of bodies that share space now by more than rounding and would collide, in order of
     * their ids; of very many only some.
     */
    public List<Overlap> overlaps() {
        return OverlapSearch.among(population.objects(), traits(), bodies, queries);
    }

    private Volume volume(int i, double offset) {
        return collidables.volumeAt(i, time + offset);
    }

    private void pose(int i, double offset, Pose to) {
        if (collidables.isBody(i)) {
            outlook.pose(collidables.slot(i), offset, to);
        } else {
            Collidable c = collidables.get(i);
            to.set(c.positionAt(time + offset), c.orientationAt(time + offset));
        }
    }
}
