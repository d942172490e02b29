package org.auvsim.core.step;

import org.auvsim.core.entity.Collidable;
import org.auvsim.core.entity.ExpandingSphere;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.PairQueries;
import org.auvsim.core.volume.Pose;
import org.auvsim.core.volume.Separation;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;

/**
 * First contact of a body on its curve with a collidable that is no body and moves by a rule of its
 * own. What is no body approaches everything: an overlap is a contact.
 *
 * <p>A wave front and a ball: the root of their polynomial. A collidable that tells how fast its
 * surface moves ({@link Collidable#fastestSurface}): conservative advancement. Any other one is
 * looked at in {@value #INSTANTS} instants and the first overlap found is bisected, so that a
 * contact between two instants can be missed.
 *
 * <p>Holds scratch: one for each thread.
 */
final class EntityImpact {
    private static final int INSTANTS = 32;
    private static final int STEPS = 10_000;

    private final PairQueries queries;
    private final SphereImpact spheres = new SphereImpact();
    private final RelativeMotion motion = new RelativeMotion();
    private final BodyCurve still = new BodyCurve();
    private final Separation gap = new Separation();
    private final Pose poseOfBody = new Pose();
    private final Pose poseOfEntity = new Pose();
    private final double[] path = new double[12];

    EntityImpact(PairQueries queries) {
        this.queries = queries;
    }

    /**
     * First time from {@code t0} to {@code t1} (s, on the clock of the body's curve) at which the
     * two touch; infinity if they do not.
     *
     * @param epoch time of the world (s) at which the clock of the curve shows 0
     */
    double first(
            Collidable entity, double epoch, BodyCurve body, Volume volume, double t0, double t1) {
        if (entity instanceof ExpandingSphere wave && volume instanceof Sphere ball) {
            return front(wave, epoch, body, ball, t0, t1);
        }
        return entity.fastestSurface(epoch + t0, epoch + t1) < Double.POSITIVE_INFINITY
                ? advance(entity, epoch, body, volume, t0, t1)
                : sample(entity, epoch, body, volume, t0, t1);
    }

    /** Part by part, as the front begins to grow and stops. */
    private double front(
            ExpandingSphere wave, double epoch, BodyCurve body, Sphere ball, double t0, double t1) {
        double from = t0;
        while (true) {
            double grows = wave.start() - epoch;
            double stops = wave.end() - epoch;
            double to = grows > from ? Math.min(grows, t1) : t1;
            to = stops > from ? Math.min(stops, to) : to;
            double found = frontWithin(wave, epoch, body, ball, from, to);
            if (found < Double.POSITIVE_INFINITY || !(to < t1)) {
                return found;
            }
            from = to;
        }
    }

    /** While the radius is linear in time. */
    private double frontWithin(
            ExpandingSphere wave, double epoch, BodyCurve body, Sphere ball, double t0, double t1) {
        Vec3 centre = wave.centre();
        body.pathWithin(t0, t1, path, 0);
        for (int i = 0; i < 12; i += 3) {
            path[i] -= centre.x();
            path[i + 1] -= centre.y();
            path[i + 2] -= centre.z();
        }
        double reach0 = wave.radiusAt(epoch + t0) + ball.radius();
        if (path[0] * path[0] + path[1] * path[1] + path[2] * path[2] <= reach0 * reach0) {
            return t0;
        }
        double reach1 = wave.radiusAt(epoch + t1) + ball.radius();
        double s = spheres.first(path, 0, reach0, reach1);
        return s <= 1 ? t0 + s * (t1 - t0) : s;
    }

    private double advance(
            Collidable entity, double epoch, BodyCurve body, Volume volume, double t0, double t1) {
        double touch = ConservativeAdvancement.CONTACT * volume.boundingRadius();
        double t = t0;
        double until = t0;
        for (int step = 0; step < STEPS; step++) {
            place(entity, epoch, body, t);
            Volume shape = entity.volumeAt(epoch + t);
            double d = queries.distance(volume, poseOfBody, shape, poseOfEntity, gap);
            if (d <= touch) {
                return t;
            }
            if (t >= until) {
                until = motion.look(body, volume, still, volume, t, t1);
            }
            // Asked again each time: a front that has stopped must not make the steps tiny.
            double fastest = entity.fastestSurface(epoch + t, epoch + t1);
            double next = Math.min(until, t + d / (motion.closing() + fastest));
            if (next >= t1) {
                return Double.POSITIVE_INFINITY;
            }
            if (next == t) {
                return t;
            }
            t = next;
        }
        return t;
    }

    private double sample(
            Collidable entity, double epoch, BodyCurve body, Volume volume, double t0, double t1) {
        if (overlap(entity, epoch, body, volume, t0)) {
            return t0;
        }
        double apart = t0;
        for (int i = 1; i <= INSTANTS; i++) {
            double t = i == INSTANTS ? t1 : t0 + (t1 - t0) * i / INSTANTS;
            if (overlap(entity, epoch, body, volume, t)) {
                return bisect(entity, epoch, body, volume, apart, t);
            }
            apart = t;
        }
        return Double.POSITIVE_INFINITY;
    }

    /** The first instant of overlap, to the last bit that bisection can tell. */
    private double bisect(
            Collidable entity,
            double epoch,
            BodyCurve body,
            Volume volume,
            double low,
            double high) {
        double apart = low;
        double overlapping = high;
        while (true) {
            double middle = 0.5 * (apart + overlapping);
            if (!(middle > apart && middle < overlapping)) {
                return overlapping;
            }
            if (overlap(entity, epoch, body, volume, middle)) {
                overlapping = middle;
            } else {
                apart = middle;
            }
        }
    }

    private boolean overlap(
            Collidable entity, double epoch, BodyCurve body, Volume volume, double t) {
        place(entity, epoch, body, t);
        return queries.overlap(volume, poseOfBody, entity.volumeAt(epoch + t), poseOfEntity);
    }

    private void place(Collidable entity, double epoch, BodyCurve body, double t) {
        Quat orientation = entity.orientationAt(epoch + t);
        poseOfEntity.set(entity.positionAt(epoch + t), orientation);
        body.poseAt(t, poseOfBody);
    }
}
