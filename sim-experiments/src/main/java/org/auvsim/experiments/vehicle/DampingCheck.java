package org.auvsim.experiments.vehicle;

import org.auvsim.core.entity.Twist;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.entity.Wrench;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;

/** What looks wrong of the forces of the water, found by trying them. */
final class DampingCheck {
    private static final double FAR = 3;
    private static final double ALIKE = 1.05;
    private static final int DRAWS = 300;
    private static final long SEED = 1;
    private static final double ROUNDING = 1e-3;

    /** Rounding of a weight, in newtons a kilogram. */
    private static final double TAKEN_OFF = 1e-8;

    private final WorldObjectDefinition vehicle;
    private final Hull hull;
    private final double density;

    DampingCheck(WorldObjectDefinition vehicle, Hull hull, double density) {
        this.vehicle = vehicle;
        this.hull = hull;
        this.density = density;
    }

    /** Force or torque (N, N m) against a unit of speed or rate along an axis, surge to yaw. */
    double against(int axis) {
        double[] unit = new double[6];
        unit[axis] = 1;
        Wrench push =
                TestTank.water(
                        vehicle,
                        new Twist(
                                new Vec3(unit[0], unit[1], unit[2]),
                                new Vec3(unit[3], unit[4], unit[5])));
        Vec3 part = axis < 3 ? push.force() : push.torque();
        return -part.component(axis % 3);
    }

    List<String> findings() {
        List<String> found = new ArrayList<>();
        if (hull.isRound()) {
            alike("sway", 1, "heave", 2, "at 1 m/s", "N", found);
            alike("pitch", 4, "yaw", 5, "at 1 rad/s", "N m", found);
        }
        if (hull.isSlender()) {
            StripTheory theory = new StripTheory(hull, density);
            crossFlow("sway", 1, theory.drag(), "N at 1 m/s", found);
            crossFlow("heave", 2, theory.drag(), "N at 1 m/s", found);
            crossFlow("pitch", 4, theory.turningDrag(), "N m at 1 rad/s", found);
            crossFlow("yaw", 5, theory.turningDrag(), "N m at 1 rad/s", found);
        }
        energy(1, "ahead", found);
        energy(-1, "astern", found);
        return found;
    }

    /** A body of revolution with equal fins is the same sideways and up and down. */
    private void alike(
            String one,
            int first,
            String other,
            int second,
            String at,
            String unit,
            List<String> to) {
        double a = against(first);
        double b = against(second);
        if (Math.max(a, b) > ALIKE * Math.min(a, b)) {
            to.add(
                    String.format(
                            Locale.ROOT,
                            "The water resists %s %s with %.4g %s but %s with %.4g %s: for a hull"
                                + " of revolution with equal fins the two are equal, so that one is"
                                + " wrong or adjusted.",
                            one,
                            at,
                            a,
                            unit,
                            other,
                            b,
                            unit));
        }
    }

    private void crossFlow(
            String axis, int index, double expected, String unit, List<String> found) {
        double stated = against(index);
        if (stated > FAR * expected || stated < expected / FAR) {
            found.add(
                    String.format(
                            Locale.ROOT,
                            "Drag in %s is %.4g %s, %.2g times the %.3g of strip theory.",
                            axis,
                            stated,
                            unit,
                            stated / expected,
                            expected));
        }
    }

    /** In still water a vehicle that only coasts never gains energy. */
    private void energy(int direction, String way, List<String> found) {
        SplittableRandom random = new SplittableRandom(SEED);
        for (int k = 0; k < DRAWS; k++) {
            Vec3 v =
                    new Vec3(
                            direction * draw(random, 0, 2),
                            draw(random, -1, 1),
                            draw(random, -1, 1));
            Vec3 w = new Vec3(draw(random, -1, 1), draw(random, -1, 1), draw(random, -1, 1));
            Wrench push = TestTank.water(vehicle, new Twist(v, w));
            double power = push.force().dot(v) + push.torque().dot(w);
            double size = push.force().norm() * v.norm() + push.torque().norm() * w.norm();
            // Weight and buoyancy have been taken off the push, which leaves their rounding.
            double left = TAKEN_OFF * vehicle.mass().orElse(0) * (v.norm() + w.norm());
            if (power > ROUNDING * size + left) {
                found.add(
                        String.format(
                                Locale.ROOT,
                                "Going %s, the water gives it energy: %.3g W at velocity (%.2f,"
                                        + " %.2f, %.2f) m/s and rate (%.2f, %.2f, %.2f) rad/s; such"
                                        + " lift terms hold within their tests alone.",
                                way,
                                power,
                                v.x(),
                                v.y(),
                                v.z(),
                                w.x(),
                                w.y(),
                                w.z()));
                return;
            }
        }
    }

    private static double draw(SplittableRandom random, double low, double high) {
        return random.nextDouble(low, high);
    }
}
