package org.auvsim.diagnosis.model;

import org.auvsim.core.effect.PeriodicForce;
import org.auvsim.core.effect.SmoothForce;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.field.OscillatingCurrent;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.Partings.Leg;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.List;
import java.util.Optional;

/**
 * What swings in one variant and not in another: a force at the origin, or the water everywhere.
 *
 * @param vector force (N) or velocity (m/s), world
 */
record Swing(Kind kind, Trace vector) {
    /** What can swing. */
    enum Kind {
        FORCE,
        CURRENT
    }

    /** A vector (world) at a place (m, world) and a time (s). */
    interface Trace {
        Vec3 at(Vec3 place, double time);
    }

    /**
     * A swing during a leg.
     *
     * @param mean over the leg
     * @param change from its beginning to its end
     * @param bend by which the mean is more than that of both ends
     */
    record Part(Vec3 mean, Vec3 change, Vec3 bend) {
        /** The three numbers along an axis. */
        double[] along(Vec3 axis) {
            return new double[] {mean.dot(axis), change.dot(axis), bend.dot(axis)};
        }
    }

    /**
     * What swings in a variant beside another; empty if it is more than that, or something else.
     */
    static Optional<Swing> of(Variant variant, Variant beside) {
        List<Effect> effects = variant.body().effect();
        List<Current> currents = variant.currents();
        if (effects.size() > beside.body().effect().size()) {
            return effects.getLast() instanceof SmoothForce force
                            && beside.with(b -> b.effect(force)).movesAs(variant)
                    ? Optional.of(new Swing(Kind.FORCE, force::at))
                    : Optional.empty();
        }
        return currents.size() > beside.currents().size()
                        && currents.getLast() instanceof OscillatingCurrent current
                        && beside.in(current).movesAs(variant)
                ? Optional.of(new Swing(Kind.CURRENT, current::valueAt))
                : Optional.empty();
    }

    /** A variant in which a vector swings beside another, at an angular frequency (rad/s). */
    static Variant in(Variant beside, Kind kind, Vec3 sine, Vec3 cosine, double omega) {
        if (kind == Kind.FORCE) {
            return beside.with(b -> b.effect(new PeriodicForce(sine, cosine, omega)));
        }
        boolean isSine = cosine.equals(Vec3.ZERO);
        return beside.in(
                new OscillatingCurrent(
                        0,
                        "swinging",
                        Vec3.ZERO,
                        isSine ? sine : cosine,
                        2 * Math.PI / omega,
                        isSine ? 0 : Math.PI / 2));
    }

    /** Its mean by Simpson's rule along the leg's way. */
    Part during(MeasuredRun run, Leg leg) {
        double begin = run.time(leg.from());
        double end = run.time(leg.to());
        Vec3 first = vector.at(leg.start().position(), begin);
        Vec3 last = vector.at(leg.end().position(), end);
        Vec3 middle = vector.at(leg.middle(end - begin), (begin + end) / 2);
        Vec3 mean = first.plus(middle.times(4)).plus(last).times(1.0 / 6);
        return new Part(mean, last.minus(first), mean.minus(first.plus(last).times(0.5)));
    }
}
