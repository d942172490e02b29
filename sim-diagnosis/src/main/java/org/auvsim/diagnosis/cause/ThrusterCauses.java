package org.auvsim.diagnosis.cause;

import org.auvsim.core.actuator.Condition;
import org.auvsim.core.actuator.Failure;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.actuator.Sag;
import org.auvsim.core.entity.Component;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.Variant;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;

/** Propulsors that do otherwise than they should. */
final class ThrusterCauses {
    /** Steeper than this (sine) a propulsor's direction counts as up or down. */
    private static final double STEEP = 0.9;

    private static final int FAILURES = 8;

    /** One that runs backwards gives no more than twice what it should. */
    private static final double BACKWARDS = -2;

    private static final Vec3 UP = new Vec3(0, 0, 1);
    private static final Vec3 LEFT = new Vec3(0, 1, 0);
    private static final Vec3 AHEAD = new Vec3(1, 0, 0);

    private ThrusterCauses() {}

    static List<Cause> of(Setting s) {
        List<Propulsor> propulsors = s.propulsors();
        List<Cause> causes = new ArrayList<>();
        if (propulsors.isEmpty()) {
            return causes;
        }
        if (propulsors.size() > 1) {
            causes.add(gain(_ -> true));
        }
        for (Propulsor p : propulsors) {
            Predicate<Propulsor> it = other -> other.name().equals(p.name());
            causes.add(gain(it).about(p.name()));
            if (pushesElsewhere(s, p, sideways(p))) {
                causes.add(turned("angle", it, sideways(p), p.name()));
            }
            if (pushesElsewhere(s, p, upwards(p))) {
                causes.add(turned("tilt", it, upwards(p), p.name()));
            }
            causes.add(loss(s, it).about(p.name()));
        }
        causes.add(deadZone());
        causes.add(lag(s));
        if (propulsors.stream().anyMatch(s::goesAstern)) {
            causes.add(astern());
        }
        causes.add(advance(s));
        causes.add(fade(s));
        return causes;
    }

    /** The model with some propulsors changed. */
    private static Variant with(
            Variant v, Predicate<Propulsor> which, UnaryOperator<Propulsor> change) {
        List<Component> components = new ArrayList<>(v.body().component());
        components.replaceAll(c -> c instanceof Propulsor p && which.test(p) ? change.apply(p) : c);
        return v.with(b -> b.components(components));
    }

    private static Condition condition(Propulsor p) {
        return p.condition().orElse(Condition.SOUND);
    }

    private static Change gain(Predicate<Propulsor> which) {
        return Change.of(
                        "thruster_gain",
                        List.of(new Parameter("factor", "1", 0.1, BACKWARDS - 1, 100)),
                        (v, t) -> with(v, which, p -> amplified(p, 1 + t[0])))
                .toldAsFactors();
    }

    private static Propulsor amplified(Propulsor p, double factor) {
        Condition c = condition(p);
        return p.in(c.gaining(c.gain() * factor));
    }

    /**
     * About the axis that turns it within the horizontal plane; about that ahead if it has none.
     */
    private static Vec3 sideways(Propulsor p) {
        return Math.abs(p.direction().z()) < STEEP ? UP : AHEAD;
    }

    /** About the axis that lifts it out of that plane; about that to the left if it is upright. */
    private static Vec3 upwards(Propulsor p) {
        return Math.abs(p.direction().z()) < STEEP ? p.direction().cross(UP).normalized() : LEFT;
    }

    /**
     * Whether it would push where the body's mount lets it go, turned about an axis; if not, that
     * is a matter of strength alone.
     */
    private static boolean pushesElsewhere(Setting s, Propulsor p, Vec3 axis) {
        Vec3 aside = s.body().orientation().rotate(axis.cross(p.direction()));
        return Setting.goes(s.body(), aside);
    }

    private static Change turned(
            String angle, Predicate<Propulsor> which, Vec3 axis, String propulsor) {
        return Change.of(
                        "thruster_misalignment",
                        List.of(new Parameter(angle, "rad", 0.05, -Math.PI / 2, Math.PI / 2)),
                        (v, t) -> {
                            Quat turn = Quat.ofAxisAngle(axis, t[0]);
                            return with(
                                    v, which, p -> p.mounted(turn.rotate(p.direction()), p.lag()));
                        })
                .about(propulsor)
                .by(angle);
    }

    private static Change loss(Setting s, Predicate<Propulsor> which) {
        double soon = 0.02 * s.path().duration();
        // What is lost before is thrust that never was, which a gain says.
        double first = s.path().begin() + soon;
        List<Parameter> parameters =
                List.of(
                        new Parameter("lost", "1", 0.1, 0, 1),
                        new Parameter("from", "s", soon, first, s.path().end()));
        List<Guess> guesses = new ArrayList<>();
        for (double time : s.path().times(FAILURES)) {
            guesses.add(Change.guess(parameters, new double[] {0, time}, 0));
        }
        double fade = OnsetCauses.STEPS * s.timeStep();
        return Change.of(
                        "thruster_loss",
                        parameters,
                        (v, t) ->
                                with(v, which, p -> failing(p, new Failure(t[1], 1 - t[0], fade))))
                .from(guesses);
    }

    private static Propulsor failing(Propulsor p, Failure failure) {
        return p.in(condition(p).failing(failure));
    }

    private static Change deadZone() {
        return Change.of(
                        "thruster_deadzone",
                        List.of(new Parameter("width", "1", 0.05, 0, 0.9)),
                        (v, t) -> with(v, _ -> true, p -> losing(p, t[0])))
                .from(List.of(Change.secant(0.05), Change.secant(0.2)));
    }

    private static Propulsor losing(Propulsor p, double width) {
        Condition c = condition(p);
        double lost = Math.min(0.99, c.lostLevel() + width);
        return p.in(c.losing(lost));
    }

    private static Change lag(Setting s) {
        return Change.of(
                        "thruster_lag",
                        List.of(
                                new Parameter(
                                        "tau", "s", 0.1, 0, Math.max(1, s.path().duration() / 4))),
                        (v, t) -> with(v, _ -> true, p -> p.mounted(p.direction(), p.lag() + t[0])))
                .from(List.of(Change.secant(0.1), Change.secant(0.5)));
    }

    /** Screws that push less astern than ahead, all of them, as they are of one make. */
    private static Change astern() {
        return Change.of(
                        "thruster_astern",
                        List.of(new Parameter("factor", "1", 0.1, -1, 100)),
                        (v, t) -> with(v, _ -> true, p -> weakerAstern(p, 1 + t[0])))
                .toldAsFactors()
                .asGeneric();
    }

    private static Propulsor weakerAstern(Propulsor p, double factor) {
        Condition c = condition(p);
        return p.in(c.pushingAstern(c.astern() * factor));
    }

    /**
     * Screws that bite less, the faster they go ahead. At a steady level that is as drag along the
     * body, and more thrust at rest, which are believed before it.
     */
    private static Change advance(Setting s) {
        double speed = s.path().speed();
        double most = s.propulsors().stream().mapToDouble(Propulsor::advanceLoss).min().orElse(0);
        return Change.of(
                        "thruster_advance",
                        List.of(new Parameter("loss", "s/m", 0.1 / speed, -most, 100 / speed)),
                        (v, t) -> with(v, _ -> true, p -> p.advancing(p.advanceLoss() + t[0])))
                .asGeneric();
    }

    /** All that fade together, as the battery empties that they draw from. */
    private static Change fade(Setting s) {
        double begin = s.path().begin();
        double most = 1 / (s.path().end() - begin);
        return Change.of(
                        "thruster_fade",
                        List.of(new Parameter("fade", "1/s", 0.1 * most, -most, most)),
                        (v, t) -> with(v, _ -> true, p -> fading(p, begin, t[0])))
                .asGeneric();
    }

    private static Propulsor fading(Propulsor p, double begin, double fade) {
        Condition c = condition(p);
        Sag believed = c.sag().orElse(new Sag(begin, 0));
        return p.in(c.sagging(new Sag(believed.from(), believed.fade() + fade)));
    }
}
