package org.auvsim.diagnosis.cause;

import org.auvsim.core.effect.Buoyancy;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;

/** Weight and buoyancy: their difference, and where the second acts. */
final class WeightCauses {

    private WeightCauses() {}

    static List<Cause> of(Setting s) {
        List<Cause> causes = new ArrayList<>();
        causes.add(
                Change.of(
                        "buoyancy_weight",
                        List.of(Parameter.signed("force", "N", s.force())),
                        (v, t) ->
                                v.with(
                                        b ->
                                                b.force(
                                                        NamedForce.direct(
                                                                name(v.body(), "found buoyancy"),
                                                                Frame.WORLD,
                                                                new Vec3(0, 0, t[0]))))));
        if (s.turnsMatter() && s.floats()) {
            causes.add(offset(s));
        }
        return causes;
    }

    private static String name(WorldObjectDefinition body, String name) {
        return name + " " + (body.force().size() + 1);
    }

    /**
     * Moves the buoyancy that the model has; a model with neither weight nor buoyancy is taken to
     * float in balance and gets both.
     */
    private static Cause offset(Setting s) {
        return Change.of(
                "cob_offset",
                Parameter.vector("offset", "m", s.torque() / (s.mass() * Earth.GRAVITY)),
                (v, t) -> v.with(b -> shifted(b, v.body(), new Vec3(t[0], t[1], t[2]))));
    }

    private static WorldObjectDefinition.Builder shifted(
            WorldObjectDefinition.Builder b, WorldObjectDefinition body, Vec3 offset) {
        if (Setting.has(body, Buoyancy.class)) {
            return b.effects(body.effect().stream().map(e -> shifted(e, offset)).toList());
        }
        Vec3 weight = new Vec3(0, 0, -Earth.GRAVITY * body.mass().orElseThrow());
        String name = name(body, "found couple");
        return b.force(new NamedForce(name + ", up", Frame.WORLD, weight.negated(), offset))
                .force(NamedForce.direct(name + ", down", Frame.WORLD, weight));
    }

    private static Effect shifted(Effect effect, Vec3 offset) {
        return effect instanceof Buoyancy b
                ? new Buoyancy(
                        b.volume(),
                        b.density(),
                        b.acceleration(),
                        b.centre().plus(offset),
                        b.surface(),
                        b.height())
                : effect;
    }
}
