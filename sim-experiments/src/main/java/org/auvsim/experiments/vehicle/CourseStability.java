package org.auvsim.experiments.vehicle;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.EigenDecomposition;
import org.auvsim.core.entity.Twist;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.Arrays;

/**
 * Whether small deviations from straight ahead die out with all controls fixed (Fossen 2021,
 * section 15.3): the greatest growth rate of the linearised motion. The Munk moment drives a
 * deviation on, the lift of hull and fins and the inertia against turning bring it back.
 *
 * @param sideways of sway and yaw (1/s); below 0 it is stable
 * @param vertical of heave, pitch rate and pitch (1/s)
 */
record CourseStability(double sideways, double vertical) {
    private static final double SMALL = 1e-5;

    /** By how much a vehicle goes off its course: sway, heave (m/s), pitch and yaw rate, pitch. */
    private record Deviation(double v, double w, double q, double r, double pitch) {
        Twist accelerations(WorldObjectDefinition vehicle, double speed, double size) {
            return TestTank.accelerations(
                    vehicle,
                    new Quat(1, 0, size * pitch / 2, 0).normalized(),
                    new Twist(
                            new Vec3(speed, size * v, size * w), new Vec3(0, size * q, size * r)));
        }

        /** How the accelerations change with it, by central differences. */
        Twist slope(WorldObjectDefinition vehicle, double speed) {
            Twist ahead = accelerations(vehicle, speed, SMALL);
            Twist back = accelerations(vehicle, speed, -SMALL);
            double by = 1 / (2 * SMALL);
            return new Twist(
                    ahead.velocity().minus(back.velocity()).times(by),
                    ahead.angularVelocity().minus(back.angularVelocity()).times(by));
        }
    }

    static CourseStability at(WorldObjectDefinition vehicle, double speed) {
        Twist v = new Deviation(1, 0, 0, 0, 0).slope(vehicle, speed);
        Twist r = new Deviation(0, 0, 0, 1, 0).slope(vehicle, speed);
        double sideways =
                growth(
                        new double[][] {
                            {v.velocity().y(), r.velocity().y()},
                            {v.angularVelocity().z(), r.angularVelocity().z()}
                        });
        Twist w = new Deviation(0, 1, 0, 0, 0).slope(vehicle, speed);
        Twist q = new Deviation(0, 0, 1, 0, 0).slope(vehicle, speed);
        Twist pitch = new Deviation(0, 0, 0, 0, 1).slope(vehicle, speed);
        double vertical =
                growth(
                        new double[][] {
                            {w.velocity().z(), q.velocity().z(), pitch.velocity().z()},
                            {
                                w.angularVelocity().y(),
                                q.angularVelocity().y(),
                                pitch.angularVelocity().y()
                            },
                            {0, 1, 0}
                        });
        return new CourseStability(sideways, vertical);
    }

    private static double growth(double[][] of) {
        EigenDecomposition eigen = new EigenDecomposition(new Array2DRowRealMatrix(of));
        return Arrays.stream(eigen.getRealEigenvalues()).max().orElseThrow();
    }
}
