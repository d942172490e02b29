package org.auvsim.core.step;

import org.auvsim.core.dynamics.ConstraintForce;
import org.auvsim.core.dynamics.Diagnosis;
import org.auvsim.core.dynamics.EquationsOfMotion;
import org.auvsim.core.dynamics.Integrator;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.Bodies;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.Collidable;
import org.auvsim.core.entity.CollisionResponse;
import org.auvsim.core.entity.Contact;
import org.auvsim.core.entity.MovementState;
import org.auvsim.core.entity.Participant;
import org.auvsim.core.entity.RigidBody;
import org.auvsim.core.entity.Twist;
import org.auvsim.core.entity.Wrench;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.ContactPoint;
import org.auvsim.core.volume.PairQueries;
import org.auvsim.core.volume.Pose;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;

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

    private final List<Collidable> collidables;
    private final int[] slots;
    private final boolean[] fixed;
    private final int[] layer;
    private final int[] ignored;
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
    private final Projection end;
    private final Projection probe;
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
        this.collidables = List.copyOf(collidables);
        this.queries = queries;
        this.fallback = fallback;
        this.time = time;
        slots = new int[collidables.size()];
        fixed = new boolean[collidables.size()];
        layer = new int[collidables.size()];
        ignored = new int[collidables.size()];
        for (int i = 0; i < slots.length; i++) {
            slots[i] = -1;
            if (collidables.get(i) instanceof RigidBody body) {
                slots[i] = body.slot();
                fixed[i] = body.isFixed();
                layer[i] = body.layer();
                ignored[i] = body.ignoredLayers();
            }
        }
        sets = new CollisionSets(this);
        Block block = new Block(equations.groups().capacity());
        Block single = new Block(block.capacity);
        IntFunction<String> names = slot -> bodies.objects().get(slot).name();
        end = new Projection(this.bodies, equations, integrator, block, single, names);
        probe = new Projection(this.bodies, equations, integrator, block, single, names);
        kept = new Snapshot(this.bodies);
    }

    /** Begins a step from the bodies' present state, at the world's {@code time} (s). */
    public void begin(double time) {
        this.time = time;
        bodies.setTime(time);
        end.forget();
        probe.forget();
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
            for (int rank = 0; rank < slots.length; rank++) {
                if (slots[rank] >= 0) {
                    traits.rank[slots[rank]] = rank;
                }
            }
            Trajectories trajectories =
                    new Trajectories(bodies, traits, equations, integrator, lanes());
            frame = Optional.of(new Frame(this, traits, trajectories, slots));
        }
        return frame.get();
    }

    private BodyTraits traits() {
        return new BodyTraits(bodies, population.objects(), fallback, asBoundingSpheres);
    }

    /** Number of collidables. */
    public int size() {
        return slots.length;
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
        return collidables.get(i).response().orElse(fallback);
    }

    /** The world's time (s) of the snapshot. */
    public double time() {
        return time;
    }

    /** Radius (m) of the bounding sphere at an offset. */
    public double radius(int i, double offset) {
        return slots[i] >= 0
                ? bodies.radius()[slots[i]]
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
        turnEndTo(offset);
        if (slots[i] >= 0) {
            end.integrateAhead(slots[i]);
        }
        return displacement(i, offset, poseA, poseB);
    }

    private double displacement(int i, double offset, Pose from, Pose to) {
        present(i, from);
        pose(i, offset, to);
        double dx = to.x - from.x;
        double dy = to.y - from.y;
        double dz = to.z - from.z;
        return Math.sqrt(dx * dx + dy * dy + dz * dz);
    }

    /**
     * Writes the smallest sphere that holds the bounding spheres now and at {@code offset} (thesis,
     * section 5.1.2): x, y, z, radius at {@code to[4 * i]} and behind.
     */
    public void sweptSphere(int i, double offset, double[] to) {
        allAt(offset);
        double distance = displacement(i, offset, poseA, poseB);
        double r0 = radius(i, 0);
        double r1 = radius(i, offset);
        int at = 4 * i;
        if (distance + Math.min(r0, r1) <= Math.max(r0, r1)) {
            writeSphere(to, at, r0 >= r1 ? poseA : poseB, Math.max(r0, r1));
            return;
        }
        double radius = (distance + r0 + r1) / 2;
        double share = (radius - r0) / distance;
        to[at] = poseA.x + share * (poseB.x - poseA.x);
        to[at + 1] = poseA.y + share * (poseB.y - poseA.y);
        to[at + 2] = poseA.z + share * (poseB.z - poseA.z);
        to[at + 3] = radius;
    }

    private static void writeSphere(double[] to, int at, Pose centre, double radius) {
        to[at] = centre.x;
        to[at + 1] = centre.y;
        to[at + 2] = centre.z;
        to[at + 3] = radius;
    }

    /** Whether a meeting of the two would be a collision at all. */
    public boolean mayCollide(int i, int j) {
        boolean twoBodies = slots[i] >= 0 && slots[j] >= 0;
        if (twoBodies) {
            return !(fixed[i] && fixed[j])
                    && (ignored[i] >>> layer[j] & 1) == 0
                    && (ignored[j] >>> layer[i] & 1) == 0;
        }
        boolean oneBody = slots[i] >= 0 || slots[j] >= 0;
        return oneBody
                && collidables.get(i).meets(collidables.get(j))
                && collidables.get(j).meets(collidables.get(i));
    }

    /**
     * Integrates the bodies of all pairs to an offset, together: cheaper than one after the other,
     * as {@link #overlap} would.
     */
    public void lookAhead(CollisionSets pairs, double offset) {
        Projection there = projection(offset);
        for (int k = 0; k < pairs.pairCount(); k++) {
            want(pairs.first(k), there);
            want(pairs.second(k), there);
        }
        there.integrateWanted();
    }

    private void want(int i, Projection there) {
        if (slots[i] >= 0) {
            there.want(slots[i]);
        }
    }

    /** Whether the two volumes share a point at an offset. */
    public boolean overlap(int i, int j, double offset) {
        count(OVERLAP);
        if (offset != 0) {
            Projection there = projection(offset);
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
        if (slots[i] < 0 || slots[j] < 0) {
            return true;
        }
        pose(i, offset, poseA);
        pose(j, offset, poseB);
        ContactPoint contact = queries.contact(volume(i, offset), poseA, volume(j, offset), poseB);
        Vec3 relative =
                velocityAt(i, offset, contact.point())
                        .minus(velocityAt(j, offset, contact.point()));
        return contact.normal().dot(relative) < -APPROACH_TOLERANCE;
    }

    private Vec3 velocityAt(int i, double offset, Vec3 point) {
        int slot = slots[i];
        Vec3 p = vector(offset, BodyState.PX, slot);
        Vec3 l = vector(offset, BodyState.LX, slot);
        Vec3 r = point.minus(vector(offset, BodyState.X, slot));
        Quat turn =
                new Quat(
                        column(offset, BodyState.QW)[slot],
                        column(offset, BodyState.QX)[slot],
                        column(offset, BodyState.QY)[slot],
                        column(offset, BodyState.QZ)[slot]);
        RigidBody body = (RigidBody) collidables.get(i);
        Twist twist = body.twistOf(new MovementState(point.minus(r), turn, p, l));
        return twist.velocity().plus(twist.angularVelocity().cross(r));
    }

    private Vec3 vector(double offset, int column, int slot) {
        return new Vec3(
                column(offset, column)[slot],
                column(offset, column + 1)[slot],
                column(offset, column + 2)[slot]);
    }

    /** A column of the state at an offset; of bodies whose pose there has been asked for. */
    private double[] column(double offset, int column) {
        return offset == 0 ? bodies.column(column) : projection(offset).column(column);
    }

    /**
     * Moves the world to an offset: the snapshot is now there.
     *
     * @throws StepException if a body would get a number that is not finite; nothing has moved then
     */
    public void commit(double offset) {
        if (offset > 0) {
            Projection there = allAt(offset);
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
        return new StepException(
                "'%s' and '%s' collide without end at %s s: %d events in one step; check their"
                                .formatted(
                                        collidables.get(a).name(),
                                        collidables.get(b).name(),
                                        time + offset,
                                        events)
                        + " forces and restitution, or shorten the time step");
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
        for (int i = 0; slot >= 0 && i < size(); i++) {
            if (slots[i] == slot) {
                throw runaway((RigidBody) collidables.get(i), offset);
            }
        }
    }

    private StepException runaway(RigidBody body, double offset) {
        String culprit = new Diagnosis(equations, bodies, body).culprit(time, offset);
        return new StepException(
                "the motion of '%s' (id %d) gets out of all bounds between %s s and %s s by %s;"
                                .formatted(body.name(), body.id(), time, time + offset, culprit)
                        + " lessen its forces or the time step");
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
        present(i, poseA);
        present(j, poseB);
        ContactPoint point = queries.contact(volume(i, 0), poseA, volume(j, 0), poseB);
        return new Contact(when, point.point(), point.normal(), participant(i), participant(j));
    }

    /** The ids of what shares space now with the collidable of an id, in order. */
    public List<Long> overlaps(long id) {
        List<Long> found = new ArrayList<>();
        int self = 0;
        while (collidables.get(self).id() != id) {
            self++;
        }
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

    private Participant participant(int i) {
        Collidable c = collidables.get(i);
        return new Participant(
                c.id(),
                c.name(),
                c.getClass(),
                c instanceof RigidBody body ? Optional.of(body.motion()) : Optional.empty());
    }

    private Volume volume(int i, double offset) {
        Volume volume = collidables.get(i).volumeAt(time + offset);
        return asBoundingSpheres ? new Sphere(volume.boundingRadius()) : volume;
    }

    private void present(int i, Pose to) {
        int slot = slots[i];
        if (slot < 0) {
            to.set(collidables.get(i).positionAt(time), collidables.get(i).orientationAt(time));
            return;
        }
        to.x = bodies.column(BodyState.X)[slot];
        to.y = bodies.column(BodyState.Y)[slot];
        to.z = bodies.column(BodyState.Z)[slot];
        to.qw = bodies.column(BodyState.QW)[slot];
        to.qx = bodies.column(BodyState.QX)[slot];
        to.qy = bodies.column(BodyState.QY)[slot];
        to.qz = bodies.column(BodyState.QZ)[slot];
    }

    private void pose(int i, double offset, Pose to) {
        if (offset == 0) {
            present(i, to);
        } else if (slots[i] >= 0) {
            projection(offset).pose(slots[i], to);
        } else {
            Collidable c = collidables.get(i);
            to.set(c.positionAt(time + offset), c.orientationAt(time + offset));
        }
    }

    /**
     * The projection of an instant: the one where the step would end is kept, others come and go.
     */
    private Projection projection(double offset) {
        if (offset == end.offset()) {
            return end;
        }
        if (offset != probe.offset()) {
            probe.turnTo(time, offset);
        }
        return probe;
    }

    private void turnEndTo(double offset) {
        if (offset != end.offset()) {
            end.turnTo(time, offset);
        }
    }

    private Projection allAt(double offset) {
        turnEndTo(offset);
        end.integrateAll();
        return end;
    }
}
