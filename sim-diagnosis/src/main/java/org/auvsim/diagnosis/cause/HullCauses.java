package org.auvsim.diagnosis.cause;

import org.auvsim.core.actuator.Fin;
import org.auvsim.core.effect.Derivative;
import org.auvsim.core.effect.HydrodynamicDerivatives;
import org.auvsim.core.effect.ReferenceAxes;
import org.auvsim.core.entity.WorldObjectDefinition;

import java.util.ArrayList;
import java.util.List;

/**
 * What the water does to the hull of a vehicle that fins steer: a slender body that goes ahead
 * lifts, as a wing of low aspect ratio, and the lift couples sway with yaw and heave with pitch
 * (Fossen 2021, chapter 6; Yasukawa &amp; Yoshimura 2015). In the plane in which a fin acts, or of
 * which the scenario states such derivatives, as of a glider.
 */
final class HullCauses {
    private HullCauses() {}

    static List<Cause> of(Setting s) {
        List<Fin> fins = FinCauses.fins(s.body());
        List<Cause> causes = new ArrayList<>();
        if (fins.stream().anyMatch(fin -> !actsUpright(fin)) || states(s.body(), "YN")) {
            causes.add(lift(s, "Yuv", "Yur", "Nuv", "Nur").about("sway and yaw"));
        }
        if (fins.stream().anyMatch(HullCauses::actsUpright) || states(s.body(), "ZM")) {
            causes.add(lift(s, "Zuw", "Zuq", "Muw", "Muq").about("heave and pitch"));
        }
        return causes;
    }

    /** Whether a hull has derivatives of one of these forces and torques. */
    private static boolean states(WorldObjectDefinition body, String forces) {
        return body.effect().stream()
                .filter(HydrodynamicDerivatives.class::isInstance)
                .map(HydrodynamicDerivatives.class::cast)
                .flatMap(of -> of.derivative().stream())
                .anyMatch(of -> forces.indexOf(of.name().charAt(0)) >= 0);
    }

    /** Whether its lift is nearer to the body's vertical than to its horizontal plane. */
    private static boolean actsUpright(Fin fin) {
        double up = fin.chord().cross(fin.span()).normalized().z();
        return up * up > 0.5;
    }

    /** Of a rod (m) of the body's mass and moment of inertia. */
    private static double length(Setting s) {
        return Math.sqrt(12 * s.inertia() / s.mass());
    }

    /** Derivatives of a force, then of a torque, each by the velocity across and by the turning. */
    private static Change lift(Setting s, String... names) {
        double damping = s.quadraticDrag();
        double lever = s.path().speed() / s.rate();
        double length = length(s);
        List<Parameter> parameters =
                List.of(
                        Parameter.signed(names[0], "kg/m", damping),
                        Parameter.signed(names[1], "kg", damping * lever),
                        Parameter.signed(names[2], "kg", damping * length),
                        Parameter.signed(names[3], "kg m", damping * lever * length));
        return Change.of(
                "hull_lift",
                parameters,
                (v, t) -> {
                    List<Derivative> derivatives = new ArrayList<>();
                    for (int i = 0; i < names.length; i++) {
                        derivatives.add(new Derivative(names[i], t[i]));
                    }
                    return v.with(
                            b ->
                                    b.effect(
                                            new HydrodynamicDerivatives(
                                                    ReferenceAxes.FLU, derivatives)));
                });
    }
}
