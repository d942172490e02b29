package org.auvsim.diagnosis.cause;

import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.AddedMass;
import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;

/** What a body resists acceleration with. */
final class InertiaCauses {
    private static final double MOST_TAKEN = 0.95;

    private InertiaCauses() {}

    static List<Cause> of(Setting s) {
        List<Cause> causes = new ArrayList<>();
        causes.add(
                Change.of(
                                "mass_error",
                                List.of(new Parameter("factor", "1", 0.1, -mostTaken(s), 100)),
                                (v, t) -> v.with(b -> heavier(b, v.body(), 1 + t[0])))
                        .toldAsFactors());
        if (s.turnsMatter()) {
            causes.add(inertia());
            if (Setting.has(s.body(), Gravity.class) && s.body().mount().isEmpty()) {
                causes.add(centre(s));
            }
        }
        causes.add(addedMass(s));
        return causes;
    }

    /** Another mass, the same tensor: what a wrong weighing gets wrong. */
    private static WorldObjectDefinition.Builder heavier(
            WorldObjectDefinition.Builder b, WorldObjectDefinition body, double factor) {
        Mat3 tensor = body.massProperties().orElseThrow().inertia();
        return b.mass(body.mass().orElseThrow() * factor).inertia(Inertia.of(tensor));
    }

    /** So that something is left of the mass in each run, whatever the body lacked there. */
    private static double mostTaken(Setting s) {
        double lack =
                s.runs().stream().mapToDouble(run -> -run.differences().mass()).max().orElse(0);
        return MOST_TAKEN * (1 - Math.max(0, lack) / s.body().mass().orElseThrow());
    }

    /** What pulls the body down acts there, and it turns about there where nothing holds it. */
    private static Cause centre(Setting s) {
        return Change.of(
                        "cog_offset",
                        Parameter.vector("offset", "m", s.torque() / (s.mass() * Earth.GRAVITY)),
                        (v, t) ->
                                v.with(
                                        b ->
                                                b.centreOfMass(
                                                        v.body()
                                                                .centreOfItsMass()
                                                                .plus(new Vec3(t[0], t[1], t[2])))))
                .asGeneric();
    }

    private static Cause inertia() {
        List<Parameter> parameters = new ArrayList<>();
        for (String axis : List.of("x", "y", "z")) {
            parameters.add(new Parameter("factor." + axis, "1", 0.1, -MOST_TAKEN, 100));
        }
        return Change.of(
                        "inertia_error",
                        parameters,
                        (v, t) ->
                                v.with(
                                        b ->
                                                b.inertia(
                                                        Inertia.of(
                                                                PrincipalInertia.scaled(
                                                                        v.body()
                                                                                .massProperties()
                                                                                .orElseThrow()
                                                                                .inertia(),
                                                                        1 + t[0],
                                                                        1 + t[1],
                                                                        1 + t[2])))))
                .toldAsFactors();
    }

    /** May be taken away only where it stands alone on the diagonal: water never gives energy. */
    private static Cause addedMass(Setting s) {
        AddedMass present =
                s.body().addedMass().orElse(new AddedMass(Vec3.ZERO, Vec3.ZERO, List.of()));
        double most = present.term().isEmpty() ? MOST_TAKEN : 0;
        double scale = 0.1 * s.body().mass().orElseThrow();
        List<Parameter> plain = Parameter.vector("ma", "kg", scale);
        Vec3 own = present.linear();
        return Change.of(
                "added_mass",
                List.of(
                        plain.get(0).atLeast(-most * own.x()),
                        plain.get(1).atLeast(-most * own.y()),
                        plain.get(2).atLeast(-most * own.z())),
                (v, t) ->
                        v.with(
                                b ->
                                        b.addedMass(
                                                new AddedMass(
                                                        own.plus(new Vec3(t[0], t[1], t[2])),
                                                        present.angular(),
                                                        present.term()))));
    }
}
