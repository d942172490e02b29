package org.auvsim.diagnosis.cause;

import org.auvsim.core.effect.AnisotropicDrag;
import org.auvsim.core.effect.Derivative;
import org.auvsim.core.effect.HydrodynamicDerivatives;
import org.auvsim.core.effect.IsotropicDrag;
import org.auvsim.core.effect.MagnusForce;
import org.auvsim.core.effect.ReferenceAxes;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;

/** Forces of the water, or the air, on what moves through it. */
final class DragCauses {
    private DragCauses() {}

    static List<Cause> of(Setting s) {
        List<Cause> causes = new ArrayList<>();
        PresentDrag present = PresentDrag.of(s);
        double speed = s.path().speed();
        causes.add(
                Change.of(
                        "linear_drag",
                        List.of(
                                Parameter.signed("c", "N s/m", s.linearDrag())
                                        .atLeast(-present.least(speed))),
                        (v, t) -> v.with(b -> b.effect(new IsotropicDrag(t[0], 0, 0)))));
        causes.add(
                Change.of(
                        "quadratic_drag",
                        List.of(
                                Parameter.signed("k", "kg/m", s.quadraticDrag())
                                        .atLeast(-present.least(speed) / speed)),
                        (v, t) -> v.with(b -> b.effect(new IsotropicDrag(0, t[0], 0)))));
        if (s.turnsMatter()) {
            causes.add(anisotropic(s, present));
            causes.add(anisotropicLinear(s, present));
            causes.add(
                    Change.of(
                            "rotational_drag",
                            List.of(
                                    Parameter.signed("c", "N m s/rad", s.torque() / s.rate())
                                            .atLeast(-present.leastAngular(s.rate()))),
                            (v, t) -> v.with(b -> b.effect(new IsotropicDrag(0, 0, t[0])))));
        }
        if (s.turnsMatter() || s.spinIsKnown()) {
            causes.add(
                    Change.of(
                            "magnus",
                            List.of(Parameter.signed("s", "kg", s.linearDrag() / s.rate())),
                            (v, t) -> v.with(b -> b.effect(new MagnusForce(t[0])))));
        }
        return causes;
    }

    /** By derivatives, as these may take from what there is. */
    private static Cause anisotropicLinear(Setting s, PresentDrag present) {
        List<String> names = List.of("Xu", "Yv", "Zw");
        List<Parameter> parameters = new ArrayList<>();
        for (int axis = 0; axis < names.size(); axis++) {
            parameters.add(
                    Parameter.vector("c", "N s/m", s.linearDrag())
                            .get(axis)
                            .atLeast(-present.of(axis, s.path().speed())));
        }
        return Change.of(
                        "anisotropic_linear_drag",
                        parameters,
                        (v, t) -> {
                            List<Derivative> derivatives = new ArrayList<>();
                            for (int axis = 0; axis < names.size(); axis++) {
                                derivatives.add(new Derivative(names.get(axis), -t[axis]));
                            }
                            return v.with(
                                    b ->
                                            b.effect(
                                                    new HydrodynamicDerivatives(
                                                            ReferenceAxes.FLU, derivatives)));
                        })
                .asGeneric();
    }

    private static Cause anisotropic(Setting s, PresentDrag present) {
        List<Parameter> parameters = new ArrayList<>();
        double speed = s.path().speed();
        for (int axis = 0; axis < 3; axis++) {
            parameters.add(
                    Parameter.vector("k", "kg/m", s.quadraticDrag())
                            .get(axis)
                            .atLeast(-present.of(axis, speed) / speed));
        }
        return Change.of(
                "anisotropic_drag",
                parameters,
                (v, t) -> v.with(b -> b.effect(new AnisotropicDrag(new Vec3(t[0], t[1], t[2])))));
    }
}
