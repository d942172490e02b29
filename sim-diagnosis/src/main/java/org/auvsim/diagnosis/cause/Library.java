package org.auvsim.diagnosis.cause;

import org.auvsim.core.effect.Buoyancy;
import org.auvsim.core.effect.IsotropicDrag;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.Variant;

import java.util.List;
import java.util.function.BiFunction;

/** The causes that are known. */
public final class Library {
    private Library() {}

    private record Plain(
            String id, List<Parameter> parameters, BiFunction<Variant, double[], Variant> change)
            implements Cause {
        @Override
        public Variant in(Variant model, double[] theta) {
            return change.apply(model, theta);
        }
    }

    /** Those that fit a body of this kind. */
    public static List<Cause> of(WorldObjectDefinition body) {
        double mass = body.mass().orElseThrow();
        return List.of(
                new Plain(
                        "linear_drag",
                        List.of(Parameter.signed("c", "N s/m", 0.1 * mass)),
                        (v, t) -> v.with(b -> b.effect(new IsotropicDrag(t[0], 0, 0)))),
                new Plain(
                        "quadratic_drag",
                        List.of(Parameter.signed("k", "kg/m", 0.1 * mass)),
                        (v, t) -> v.with(b -> b.effect(new IsotropicDrag(0, t[0], 0)))),
                new Plain(
                        "rotational_drag",
                        List.of(Parameter.signed("c", "N m s/rad", 0.01 * mass)),
                        (v, t) -> v.with(b -> b.effect(new IsotropicDrag(0, 0, t[0])))),
                new Plain(
                        "current_constant",
                        List.of(
                                Parameter.signed("u.x", "m/s", 0.1),
                                Parameter.signed("u.y", "m/s", 0.1),
                                Parameter.signed("u.z", "m/s", 0.1)),
                        (v, t) ->
                                v.in(
                                        new UniformCurrent(
                                                1, "found", new Vec3(t[0], t[1], t[2])))),
                new Plain(
                        "mass_error",
                        List.of(Parameter.signed("factor-1", "1", 0.1)),
                        (v, t) -> v.with(b -> b.mass(v.body().mass().orElseThrow() * (1 + t[0])))),
                new Plain(
                        "buoyancy_weight",
                        List.of(Parameter.signed("force", "N", 0.1 * mass)),
                        (v, t) ->
                                v.with(
                                        b ->
                                                b.force(
                                                        org.auvsim.core.entity.NamedForce.direct(
                                                                "found " + v.body().force().size(),
                                                                org.auvsim.core.entity.Frame.WORLD,
                                                                new Vec3(0, 0, t[0]))))));
    }
}
