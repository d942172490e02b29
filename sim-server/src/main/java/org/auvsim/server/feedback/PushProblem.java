package org.auvsim.server.feedback;

import org.auvsim.auvsml.document.MomentumRule;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.Wrench;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.Optional;

/**
 * Which forces and torques end a step as it was measured. The unknowns, all in metres and radians,
 * are by how much they would shift the end of the step of a free body: its position and its
 * velocity times half the step, its turn and its angular velocity times half the step.
 */
final class PushProblem {
    private final Correction correction;
    private final RigidMotion goal;
    private final boolean moves;
    private final boolean turns;
    private final boolean inHalves;
    private final double half;
    private final double mass;
    private final Mat3 inertia;
    private final Quat start;

    PushProblem(Correction correction, MomentumRule rule) {
        Target target = correction.target();
        WorldObject object = correction.object();
        this.correction = correction;
        goal = target.replacing(correction.projected());
        moves = target.position().isPresent() || target.velocity().isPresent();
        turns = target.orientation().isPresent() || target.angularVelocity().isPresent();
        inHalves = rule == MomentumRule.PROJECTED;
        half = correction.duration() / 2;
        mass = object.mass();
        inertia = object.definition().massProperties().orElseThrow().inertia();
        start = object.orientation();
    }

    int unknowns() {
        return ((moves ? 3 : 0) + (turns ? 3 : 0)) * (inHalves ? 2 : 1);
    }

    /** By how much the step ends beside what is wanted; empty if it cannot be made. */
    Optional<double[]> miss(double[] shift) {
        return correction.tried(first(shift), second(shift)).map(this::miss);
    }

    private double[] miss(RigidMotion end) {
        Target target = correction.target();
        Components miss = new Components(unknowns());
        if (moves) {
            miss.add(
                    end.position().minus(goal.position()),
                    end.velocity().minus(goal.velocity()).times(half),
                    target.position().isPresent());
        }
        if (turns) {
            miss.add(
                    Turns.between(goal.orientation(), end.orientation()),
                    end.angularVelocity().minus(goal.angularVelocity()).times(half),
                    target.orientation().isPresent());
        }
        return miss.values;
    }

    /** Gathers three or six numbers for each kind of motion. */
    private final class Components {
        private final double[] values;
        private int count;

        Components(int size) {
            values = new double[size];
        }

        void add(Vec3 place, Vec3 speed, boolean isPlaceMeasured) {
            if (inHalves) {
                add(place);
                add(speed);
            } else {
                add(isPlaceMeasured ? place : speed);
            }
        }

        private void add(Vec3 v) {
            values[count++] = v.x();
            values[count++] = v.y();
            values[count++] = v.z();
        }
    }

    void push(double[] shift) {
        correction.push(first(shift), second(shift));
    }

    private Wrench first(double[] shift) {
        return new Wrench(
                moves ? firstShare(shift, 0).times(mass) : Vec3.ZERO,
                turns ? torque(firstShare(shift, turnsAt())) : Vec3.ZERO);
    }

    private Wrench second(double[] shift) {
        return new Wrench(
                moves ? secondShare(shift, 0).times(mass) : Vec3.ZERO,
                turns ? torque(secondShare(shift, turnsAt())) : Vec3.ZERO);
    }

    private int turnsAt() {
        return moves ? unknowns() / 2 : 0;
    }

    /** In the body's axes, for an angular acceleration in the world's. */
    private Vec3 torque(Vec3 acceleration) {
        return inertia.times(start.rotateInverse(acceleration));
    }

    /** The acceleration in the first half of the step. */
    private Vec3 firstShare(double[] shift, int from) {
        Vec3 place = vector(shift, from);
        return inHalves
                ? place.minus(vector(shift, from + 3).times(0.5)).times(1 / (half * half))
                : place.times(0.5 / (half * half));
    }

    /** The acceleration in the second half of the step. */
    private Vec3 secondShare(double[] shift, int from) {
        Vec3 first = firstShare(shift, from);
        return inHalves ? vector(shift, from + 3).times(1 / (half * half)).minus(first) : first;
    }

    private static Vec3 vector(double[] shift, int from) {
        return new Vec3(shift[from], shift[from + 1], shift[from + 2]);
    }
}
