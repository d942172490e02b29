package org.auvsim.core.step;

import org.auvsim.core.entity.Actuator;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.RigidBody;
import org.auvsim.core.entity.Wrench;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;

import java.util.Locale;

/** The paths of spheres under constant forces; refuses by name what moves otherwise. */
final class ParabolicPaths {
    /** What rounding may do to a position (relative to its size and to the way gone). */
    private static final double ROUNDING = 1e-12;

    private ParabolicPaths() {}

    /**
     * The path of each collidable over a step.
     *
     * @throws StepException naming the first one whose path is no parabola, or that is no sphere
     */
    static Parabola[] of(Motion motion, double dt) {
        Parabola[] paths = new Parabola[motion.size()];
        for (int i = 0; i < paths.length; i++) {
            if (!(motion.collidable(i) instanceof RigidBody body)) {
                throw refused(motion, i, "it is no rigid body");
            }
            if (!(body.volume() instanceof Sphere)) {
                String volume = body.volume().getClass().getSimpleName();
                throw refused(motion, i, "its volume is no sphere but a " + volume);
            }
            if (!body.isFixed()) {
                refuseTurning(motion, i, body);
            }
            paths[i] = path(motion, i, body, dt);
        }
        return paths;
    }

    private static void refuseTurning(Motion motion, int i, RigidBody body) {
        if (body.angularMomentum().norm() > 0) {
            throw refused(motion, i, "it turns");
        }
        for (NamedForce force : body.forces()) {
            if (force.frame() == Frame.BODY) {
                throw refused(motion, i, "its force '" + force.name() + "' is fixed in body axes");
            }
            if (force.point().cross(force.vector()).norm() > 0) {
                throw refused(motion, i, "its force '" + force.name() + "' makes it turn");
            }
        }
        for (Actuator actuator : body.actuators()) {
            if (actuator.constantPush().filter(ParabolicPaths::isNothing).isEmpty()) {
                String kind = actuator.getClass().getSimpleName().toLowerCase(Locale.ROOT);
                throw refused(
                        motion,
                        i,
                        "its %s '%s' pushes in body axes".formatted(kind, actuator.name()));
            }
        }
    }

    private static boolean isNothing(Wrench push) {
        return push.force().norm() == 0 && push.torque().norm() == 0;
    }

    /**
     * The parabola through the beginning, with the velocity there, and the integrated end: that of
     * a constant force. Whether the force is constant shows in mid-step.
     */
    private static Parabola path(Motion motion, int i, RigidBody body, double dt) {
        Vec3 place = motion.position(i, 0);
        Vec3 end = motion.position(i, dt);
        Vec3 way = body.velocity().times(dt);
        Vec3 acceleration = end.minus(place.plus(way)).times(2 / (dt * dt));
        Parabola path = new Parabola(place, body.velocity(), acceleration);
        double size = place.norm() + end.norm() + way.norm();
        if (!(path.at(dt / 2).distance(motion.position(i, dt / 2)) <= ROUNDING * size)) {
            throw refused(motion, i, "its acceleration varies" + effects(body));
        }
        return path;
    }

    private static String effects(RigidBody body) {
        return body.effects().stream()
                .map(effect -> effect.getClass().getSimpleName())
                .reduce((one, other) -> one + ", " + other)
                .map(names -> " (effects on it: " + names + ")")
                .orElse("");
    }

    private static StepException refused(Motion motion, int i, String why) {
        return new StepException(
                "the analytic finder cannot follow '%s' (id %d) at %s s: %s; choose another finder,"
                                .formatted(
                                        motion.collidable(i).name(),
                                        motion.collidable(i).id(),
                                        motion.time(),
                                        why)
                        + " such as the bisection finder");
    }
}
