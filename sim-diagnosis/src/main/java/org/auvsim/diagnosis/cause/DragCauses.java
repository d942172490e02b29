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
import java.util.function.Function;
import java.util.stream.IntStream;

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
        if (s.turnsMatter() || s.isToSpin()) {
            causes.add(
                    Change.of(
                            "magnus",
                            List.of(Parameter.signed("s", "kg", s.linearDrag() / s.rate())),
                            (v, t) -> v.with(b -> b.effect(new MagnusForce(t[0])))));
        } else if (s.maySpin()) {
            causes.add(magnusOfUnseenSpin(s));
        }
        return causes;
    }

    /**
     * By derivatives of a body that is not believed to turn: F = (s w) x v. How it is turned, and
     * so where the spin points to, each run tells for itself: the size alone is told.
     */
    private static Cause magnusOfUnseenSpin(Setting s) {
        return derivatives(
                        "magnus",
                        Parameter.vector("sw", "kg/s", s.linearDrag()),
                        sw ->
                                List.of(
                                        new Derivative("Xv", -sw[2]),
                                        new Derivative("Xw", sw[1]),
                                        new Derivative("Yu", sw[2]),
                                        new Derivative("Yw", -sw[0]),
                                        new Derivative("Zu", -sw[1]),
                                        new Derivative("Zv", sw[0])))
                .told(sw -> List.of(new Quantity("sw", "kg/s", size(sw))))
                .asGeneric();
    }

    private static double size(double[] vector) {
        return new Vec3(vector[0], vector[1], vector[2]).norm();
    }

    private static Change derivatives(
            String id, List<Parameter> parameters, Function<double[], List<Derivative>> of) {
        return Change.of(
                id,
                parameters,
                (v, t) ->
                        v.with(
                                b ->
                                        b.effect(
                                                new HydrodynamicDerivatives(
                                                        ReferenceAxes.FLU, of.apply(t)))));
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
        return derivatives(
                        "anisotropic_linear_drag",
                        parameters,
                        c ->
                                IntStream.range(0, c.length)
                                        .mapToObj(i -> new Derivative(names.get(i), -c[i]))
                                        .toList())
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
