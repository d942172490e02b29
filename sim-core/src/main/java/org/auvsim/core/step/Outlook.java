package org.auvsim.core.step;

import org.auvsim.core.dynamics.EquationsOfMotion;
import org.auvsim.core.dynamics.Integrator;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.Bodies;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.MovementState;
import org.auvsim.core.entity.RigidBody;
import org.auvsim.core.entity.Twist;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Pose;

import java.util.function.IntFunction;

/**
 * The states of the bodies from the present snapshot on, by slot and offset (s): the present ones,
 * those where the step would end, which are kept, and those of one more instant, which come and go.
 */
final class Outlook {
    private final BodyState bodies;
    private final Projection end;
    private final Projection probe;
    private double time;

    /** Of these bodies. */
    Outlook(Bodies population, EquationsOfMotion equations, Integrator integrator) {
        bodies = population.state();
        IntFunction<String> names = slot -> population.objects().get(slot).name();
        Block block = new Block(equations.groups().capacity());
        end = new Projection(bodies, equations, integrator, block, names);
        probe = new Projection(bodies, equations, integrator, block, names);
    }

    /** Looks from the present state on, which is that of a time (s). */
    void begin(double now) {
        time = now;
        end.forget();
        probe.forget();
    }

    /** What is known of an instant after the present one. */
    Projection at(double offset) {
        if (offset == end.offset()) {
            return end;
        }
        if (offset != probe.offset()) {
            probe.turnTo(time, offset);
        }
        return probe;
    }

    /** What is known of an instant at which the step may end. */
    Projection atEnd(double offset) {
        if (offset != end.offset()) {
            end.turnTo(time, offset);
        }
        return end;
    }

    /** All bodies at an instant at which the step may end. */
    Projection allAtEnd(double offset) {
        atEnd(offset).integrateAll();
        return end;
    }

    /** Where a body is at an offset. */
    void pose(int slot, double offset, Pose to) {
        if (offset == 0) {
            bodies.pose(slot, to);
        } else {
            at(offset).pose(slot, to);
        }
    }

    /** The velocity (m/s) of a body's point (m) at an offset for which its pose has been asked. */
    Vec3 velocityAt(RigidBody body, Vec3 point, double offset) {
        MovementState state = state(body.slot(), offset);
        Twist twist = body.twistOf(state);
        Vec3 r = point.minus(state.position());
        return twist.velocity().plus(twist.angularVelocity().cross(r));
    }

    private MovementState state(int slot, double offset) {
        return new MovementState(
                vector(BodyState.X, slot, offset),
                new Quat(
                        column(BodyState.QW, offset)[slot],
                        column(BodyState.QX, offset)[slot],
                        column(BodyState.QY, offset)[slot],
                        column(BodyState.QZ, offset)[slot]),
                vector(BodyState.PX, slot, offset),
                vector(BodyState.LX, slot, offset));
    }

    private Vec3 vector(int column, int slot, double offset) {
        return new Vec3(
                column(column, offset)[slot],
                column(column + 1, offset)[slot],
                column(column + 2, offset)[slot]);
    }

    private double[] column(int column, double offset) {
        return offset == 0 ? bodies.column(column) : at(offset).column(column);
    }
}
