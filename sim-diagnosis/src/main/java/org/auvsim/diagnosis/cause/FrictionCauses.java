package org.auvsim.diagnosis.cause;

import org.auvsim.core.effect.CoulombFriction;
import org.auvsim.core.effect.PivotFriction;
import org.auvsim.core.entity.Pinned;
import org.auvsim.core.entity.WorldObjectDefinition;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** Dry friction, in a pivot or on what the body slides on, and what contacts do. */
final class FrictionCauses {

    /** Speeds (shares of the typical one) below which friction falls to nothing. */
    private static final double SLIP = 0.01;

    /** Shares of that slip speed at which to begin. */
    private static final List<Double> SLIPS = List.of(1.0, 4.0, 16.0, 0.25);

    /** The lowest and the highest share of it which may be found. */
    private static final double LEAST = 0.05;

    private static final double MOST = 20;

    /** Shares of (the root of) a contact's friction: less by one of them a body slides at last. */
    private static final List<Double> LESS = List.of(0.25, 0.5, 0.75);

    private static final double MOST_ROOT = 3;

    private FrictionCauses() {}

    static List<Cause> of(Setting s) {
        List<Cause> causes = new ArrayList<>();
        if (s.body().mount().filter(Pinned.class::isInstance).isPresent()) {
            double slip = pivotSlip(s);
            causes.add(
                    Change.of(
                            "coulomb_torque",
                            List.of(Parameter.positive("c", "N m", s.torque())),
                            (v, t) -> v.with(b -> b.effect(new PivotFriction(t[0], 0, slip)))));
        } else {
            Parameter mu = Parameter.positive("mu", "1", s.force() / (s.mass() * Earth.GRAVITY));
            double slip = SLIP * s.path().speed();
            Parameter other = new Parameter("slip", "m/s", slip, LEAST * slip, MOST * slip);
            Cause creeping = creeping(List.of(mu, other), slip);
            causes.add(sliding(List.of(mu), t -> slip).freedAs(creeping));
        }
        if (mayTouch(s)) {
            causes.addAll(contacts(s.body()));
        }
        return causes;
    }

    private static Change sliding(List<Parameter> parameters, ToDoubleFunction<double[]> slip) {
        return Change.of(
                "coulomb_friction",
                parameters,
                (v, t) ->
                        v.with(
                                b ->
                                        b.effect(
                                                new CoulombFriction(
                                                        t[0],
                                                        Earth.GRAVITY,
                                                        slip.applyAsDouble(t)))));
    }

    /** What rests for long tells how it creeps; what slides tells nothing of it. */
    private static Change creeping(List<Parameter> parameters, double slip) {
        return sliding(parameters, t -> t[1])
                .by("creeping")
                .from(
                        SLIPS.stream()
                                .map(share -> new double[] {0, share * slip})
                                .map(begin -> Change.guess(parameters, begin, 0))
                                .toList());
    }

    /** That of a friction which the model has; else a share of the typical rate (rad/s). */
    private static double pivotSlip(Setting s) {
        return s.body().effect().stream()
                .filter(PivotFriction.class::isInstance)
                .mapToDouble(effect -> ((PivotFriction) effect).slipRate())
                .findFirst()
                .orElse(SLIP * s.rate());
    }

    private static boolean mayTouch(Setting s) {
        return s.model().scenario().worldObject().stream().anyMatch(WorldObjectDefinition::fixed);
    }

    /** Of two bodies the geometric mean of the frictions counts, which is linear in a root. */
    private static List<Cause> contacts(WorldObjectDefinition body) {
        double e = body.restitution();
        double root = Math.sqrt(body.friction());
        return List.of(
                Change.of(
                                "restitution",
                                List.of(new Parameter("e", "1", 0.1, -e, 1 - e)),
                                (v, t) -> v.with(b -> b.restitution(e + t[0])))
                        .from(List.of(Change.secant(e > 0.5 ? -0.05 : 0.05)))
                        .told(t -> List.of(new Quantity("e", "1", e + t[0]))),
                Change.of(
                                "contact_friction",
                                List.of(new Parameter("root_mu", "1", 0.1, -root, MOST_ROOT)),
                                (v, t) -> v.with(b -> b.friction(square(root + t[0]))))
                        .from(moreAndLess(root))
                        .told(t -> List.of(new Quantity("mu", "1", square(root + t[0])))));
    }

    /** More or much less of it: what grips tells nothing of a little less. */
    private static List<Guess> moreAndLess(double root) {
        List<Guess> guesses = new ArrayList<>();
        guesses.add(Change.secant(0.05));
        if (root > 0) {
            LESS.forEach(share -> guesses.add(Change.beyond(-share * root)));
        }
        return guesses;
    }

    private static double square(double root) {
        return root * root;
    }
}
