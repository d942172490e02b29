package org.auvsim.viz.scene;

import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;

import java.util.List;

/** One object of a scene: its last two states, and what lies between them at the time shown. */
final class Actor implements ActorView {
    /** x, y, z, then the orientation's w, x, y, z, velocity and angular velocity. */
    static final int STATE = 13;

    private static final int TURN = 3;
    private static final int VELOCITY = 7;
    private static final int SPIN = 10;

    /** A measurement is shown for so long (s of the world). */
    private static final double MEASURED_FOR = 2;

    /** World times this near (s) are the same: they are rounded sums. */
    private static final double ROUNDING = 1e-9;

    private final double[] before = new double[STATE];
    private final double[] now = new double[STATE];
    private final double[] shown = new double[STATE];
    private final double[] projected = new double[STATE];
    private final double[] measured = new double[3];
    private final Trail trail;
    private SeenObject object;
    private double radius;
    private List<NamedForce> forces = List.of();
    private double timeBefore;
    private double timeNow;
    private double timeShown;
    private double timeProjected = Double.NEGATIVE_INFINITY;
    private double timeMeasured = Double.NEGATIVE_INFINITY;

    /** Stands at a time (s) where it is described, and remembers so many states at most. */
    Actor(SeenObject object, double time, int remembered) {
        this.object = object;
        trail = new Trail(remembered);
        now[TURN] = 1;
        become(object);
        object.definition().ifPresent(definition -> stand(definition, time));
    }

    /** Takes what it is made of; what never moves stands where that says. */
    void become(SeenObject other) {
        object = other;
        radius = other.definition().map(d -> d.volume().boundingRadius()).orElse(0.0);
        forces = other.definition().map(WorldObjectDefinition::force).orElse(forces);
        if (other.isFixed()) {
            other.definition().ifPresent(definition -> stand(definition, timeNow));
        }
    }

    /** When it was described the world had a time of its own, so that its trail begins later. */
    private void stand(WorldObjectDefinition definition, double time) {
        appear(
                new Movement(
                        time,
                        definition.position(),
                        definition.orientation(),
                        definition.velocity(),
                        definition.angularVelocity()));
    }

    /** Is somewhere else all at once. */
    void jump(Movement motion) {
        appear(motion);
        trail.add(motion);
    }

    private void appear(Movement motion) {
        write(motion, now);
        timeNow = motion.time();
        System.arraycopy(now, 0, before, 0, STATE);
        timeBefore = timeNow;
        timeProjected = Double.NEGATIVE_INFINITY;
        timeMeasured = Double.NEGATIVE_INFINITY;
        trail.clear();
    }

    /** Has moved on; a state of the same time replaces the last one, an older one begins anew. */
    void move(Movement motion) {
        if (motion.time() < timeNow) {
            jump(motion);
            return;
        }
        if (motion.time() > timeNow) {
            System.arraycopy(now, 0, before, 0, STATE);
            timeBefore = timeNow;
        }
        write(motion, now);
        timeNow = motion.time();
        trail.add(motion);
    }

    void project(Movement motion) {
        write(motion, projected);
        timeProjected = motion.time();
    }

    void measure(double time, double x, double y, double z) {
        measured[0] = x;
        measured[1] = y;
        measured[2] = z;
        timeMeasured = time;
    }

    void setForces(List<NamedForce> others) {
        forces = List.copyOf(others);
    }

    private static void write(Movement motion, double[] to) {
        to[0] = motion.position().x();
        to[1] = motion.position().y();
        to[2] = motion.position().z();
        to[3] = motion.orientation().w();
        to[4] = motion.orientation().x();
        to[5] = motion.orientation().y();
        to[6] = motion.orientation().z();
        to[7] = motion.velocity().x();
        to[8] = motion.velocity().y();
        to[9] = motion.velocity().z();
        to[10] = motion.angularVelocity().x();
        to[11] = motion.angularVelocity().y();
        to[12] = motion.angularVelocity().z();
    }

    /** Shows it as it is at a time (s): between its last two states, or at one of them. */
    void showAt(double time) {
        timeShown = time;
        double length = timeNow - timeBefore;
        double share = length > 0 ? Math.clamp((time - timeBefore) / length, 0, 1) : 1;
        for (int k = 0; k < STATE; k++) {
            shown[k] = before[k] + share * (now[k] - before[k]);
        }
        turn(share);
    }

    /** The shorter way between two unit quaternions, straight and made unit again. */
    private void turn(double share) {
        double dot = 0;
        for (int k = TURN; k < VELOCITY; k++) {
            dot += before[k] * now[k];
        }
        double sign = dot < 0 ? -1 : 1;
        double square = 0;
        for (int k = TURN; k < VELOCITY; k++) {
            shown[k] = (1 - share) * before[k] + share * sign * now[k];
            square += shown[k] * shown[k];
        }
        double factor = 1 / Math.sqrt(square);
        for (int k = TURN; k < VELOCITY; k++) {
            shown[k] *= factor;
        }
    }

    double newest() {
        return timeNow;
    }

    @Override
    public SeenObject object() {
        return object;
    }

    @Override
    public double radius() {
        return radius;
    }

    @Override
    public double position(int axis) {
        return shown[axis];
    }

    @Override
    public double orientation(int k) {
        return shown[TURN + k];
    }

    @Override
    public double velocity(int axis) {
        return shown[VELOCITY + axis];
    }

    @Override
    public double angularVelocity(int axis) {
        return shown[SPIN + axis];
    }

    /** States and projections may come a step apart: not each of short steps is told. */
    @Override
    public boolean isProjected() {
        return timeProjected > timeBefore + ROUNDING;
    }

    @Override
    public double projectedPosition(int axis) {
        return projected[axis];
    }

    @Override
    public double projectedOrientation(int k) {
        return projected[TURN + k];
    }

    @Override
    public boolean isMeasured() {
        return Math.abs(timeShown - timeMeasured) <= MEASURED_FOR;
    }

    @Override
    public double measuredPosition(int axis) {
        return measured[axis];
    }

    @Override
    public int trailLength() {
        return trail.count();
    }

    @Override
    public double trail(int i, int axis) {
        return trail.place(i, axis);
    }

    @Override
    public double trailTime(int i) {
        return trail.time(i);
    }

    @Override
    public double trailSpeed(int i) {
        return trail.speed(i);
    }

    @Override
    public double trailYaw(int i) {
        return trail.yaw(i);
    }

    @Override
    public List<NamedForce> forces() {
        return forces;
    }
}
