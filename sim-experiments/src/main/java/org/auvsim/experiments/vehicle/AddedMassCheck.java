package org.auvsim.experiments.vehicle;

import org.auvsim.core.entity.AddedMass;
import org.auvsim.core.entity.MotionAxis;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Numbers;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;

/**
 * The added mass that a vehicle states beside that of an ellipsoid of its proportions and
 * displacement, and for long round hulls that of strip theory.
 *
 * @param stated diagonal, surge to yaw (kg, kg m^2)
 * @param ellipsoid likewise
 * @param strips likewise; empty where strip theory says nothing
 */
record AddedMassCheck(Numbers stated, Numbers ellipsoid, List<OptionalDouble> strips) {
    private static final double FAR = 3;

    /** Shares of the greatest value of its kind below which an entry is not worth a word. */
    private static final double SLIGHT = 0.01;

    static AddedMassCheck of(WorldObjectDefinition vehicle, Hydrostatics at, Hull hull) {
        Vec3 none = Vec3.ZERO;
        Numbers stated =
                six(
                        vehicle.addedMass().map(AddedMass::linear).orElse(none),
                        vehicle.addedMass().map(AddedMass::angular).orElse(none));
        double volume = at.displaced() > 0 ? at.displaced() / at.density() : 0;
        Ellipsoid ellipsoid = hull.ellipsoid(volume);
        Numbers estimated =
                volume > 0
                        ? six(ellipsoid.linear(at.density()), ellipsoid.angular(at.density()))
                        : six(none, none);
        return new AddedMassCheck(stated, estimated, strips(hull, at.density()));
    }

    private static Numbers six(Vec3 linear, Vec3 angular) {
        return Numbers.of(
                linear.x(), linear.y(), linear.z(), angular.x(), angular.y(), angular.z());
    }

    private static List<OptionalDouble> strips(Hull hull, double density) {
        OptionalDouble none = OptionalDouble.empty();
        if (!hull.isSlender()) {
            return List.of(none, none, none, none, none, none);
        }
        StripTheory theory = new StripTheory(hull, density);
        OptionalDouble mass = OptionalDouble.of(theory.addedMass());
        OptionalDouble inertia = OptionalDouble.of(theory.addedInertia());
        return List.of(none, mass, mass, OptionalDouble.of(0), inertia, inertia);
    }

    /** A sentence for each axis on which the stated value is far from what theory says. */
    List<String> findings() {
        List<String> found = new ArrayList<>();
        for (MotionAxis axis : MotionAxis.values()) {
            int i = axis.index();
            double expected = strips.get(i).orElse(ellipsoid.get(i));
            double least = SLIGHT * largest(i);
            if (expected > least
                    && (stated.get(i) > FAR * expected || stated.get(i) < expected / FAR)) {
                found.add(
                        String.format(
                                Locale.ROOT,
                                "Added mass in %s is %.3g %s, but %s says %.3g.",
                                axis.name().toLowerCase(Locale.ROOT),
                                stated.get(i),
                                i < 3 ? "kg" : "kg m^2",
                                strips.get(i).isPresent() ? "strip theory" : "an ellipsoid",
                                expected));
            }
        }
        return found;
    }

    private double largest(int i) {
        int first = i < 3 ? 0 : 3;
        return Math.max(
                ellipsoid.get(first), Math.max(ellipsoid.get(first + 1), ellipsoid.get(first + 2)));
    }
}
