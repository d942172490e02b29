package org.auvsim.experiments.vehicle;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** What looks wrong of masses, weight and buoyancy. */
final class WeightCheck {
    private static final double UNBALANCED = 0.005;
    private static final double ASIDE = 1e-3;

    private WeightCheck() {}

    static List<String> findings(WorldObjectDefinition vehicle, Hydrostatics at) {
        List<String> found = new ArrayList<>();
        inertia(vehicle.massProperties().orElseThrow().inertia(), found);
        if (at.weight() == 0 || at.buoyancy() == 0) {
            found.add(
                    "It has no %s; add the effect if it is to float, sink or right itself."
                            .formatted(at.weight() == 0 ? "weight" : "buoyancy"));
            return found;
        }
        balance(at, found);
        centres(at, found);
        return found;
    }

    /** No body has a moment of inertia greater than the sum of the other two. */
    private static void inertia(Mat3 tensor, List<String> found) {
        double sum = tensor.xx() + tensor.yy() + tensor.zz();
        double greatest = Math.max(tensor.xx(), Math.max(tensor.yy(), tensor.zz()));
        if (greatest > sum - greatest) {
            found.add(
                    String.format(
                            Locale.ROOT,
                            "No body has these moments of inertia: %.3g kg m^2 is more than the"
                                    + " other two together.",
                            greatest));
        }
    }

    private static void balance(Hydrostatics at, List<String> found) {
        double excess = at.buoyancy() - at.weight();
        if (Math.abs(at.excess()) > UNBALANCED) {
            found.add(
                    String.format(
                            Locale.ROOT,
                            "Buoyancy is %.1f N %s than weight (%.1f %%): it %s.",
                            Math.abs(excess),
                            excess > 0 ? "more" : "less",
                            100 * Math.abs(at.excess()),
                            excess > 0 ? "rises" : "sinks"));
        }
    }

    private static void centres(Hydrostatics at, List<String> found) {
        if (at.metacentricHeight() <= 0) {
            found.add(
                    String.format(
                            Locale.ROOT,
                            "Nothing rights it: the centre of buoyancy is %.4g m %s that of mass.",
                            Math.abs(at.metacentricHeight()),
                            at.metacentricHeight() < 0 ? "below" : "above"));
        }
        Vec3 apart = at.centreOfBuoyancy().minus(at.centreOfMass());
        if (Math.max(Math.abs(apart.x()), Math.abs(apart.y())) > ASIDE) {
            found.add(
                    String.format(
                            Locale.ROOT,
                            "The centre of buoyancy is %.4g m ahead and %.4g m to port of that of"
                                    + " mass: it rests inclined.",
                            apart.x(),
                            apart.y()));
        }
    }
}
