package org.auvsim.viz.driving;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.math.Vec3;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Shares a wanted force and torque among propulsors, by the damped pseudo-inverse of what each of
 * them does at full thrust.
 */
final class Thrust {
    /** Of the largest singular value: what is harder to reach than this is given up. */
    private static final double DAMPING = 1e-3;

    /** Roll is kept small, but not at the cost of what is asked for. */
    private static final double WEIGHT_OF_ROLL = 0.03;

    private final List<Thruster> thrusters;
    private final RealMatrix inverse;

    /** The most force (N) and torque (N m) along and about each axis. */
    private final double[] most = new double[6];

    private final double[] weight = {1, 1, 1, WEIGHT_OF_ROLL, 1, 1};

    Thrust(List<Propulsor> propulsors, Vec3 centre) {
        thrusters = propulsors.stream().map(Thruster::new).toList();
        RealMatrix wrenches = new Array2DRowRealMatrix(6, Math.max(1, propulsors.size()));
        double longest = 0;
        for (Propulsor p : propulsors) {
            longest = Math.max(longest, p.position().minus(centre).norm());
        }
        for (int axis = 3; axis < 6; axis++) {
            weight[axis] /= longest > 0 ? longest : 1;
        }
        for (int k = 0; k < propulsors.size(); k++) {
            double[] wrench = wrench(thrusters.get(k), centre);
            for (int axis = 0; axis < 6; axis++) {
                most[axis] += Math.abs(wrench[axis]);
                wrenches.setEntry(axis, k, weight[axis] * wrench[axis]);
            }
        }
        inverse = damped(new SingularValueDecomposition(wrenches));
    }

    private static double[] wrench(Thruster thruster, Vec3 centre) {
        Propulsor p = thruster.propulsor();
        Vec3 force = p.direction().times(thruster.reach());
        Vec3 torque = p.position().minus(centre).cross(force).plus(force.times(p.reactionTorque()));
        return new double[] {force.x(), force.y(), force.z(), torque.x(), torque.y(), torque.z()};
    }

    private static RealMatrix damped(SingularValueDecomposition svd) {
        double[] singular = svd.getSingularValues();
        double damping = DAMPING * singular[0];
        RealMatrix inverse = new Array2DRowRealMatrix(singular.length, singular.length);
        for (int i = 0; i < singular.length; i++) {
            double s = singular[i];
            inverse.setEntry(i, i, s > 0 ? s / (s * s + damping * damping) : 0);
        }
        return svd.getV().multiply(inverse).multiply(svd.getUT());
    }

    /** Levels by name; none beyond -1 or 1, all lessened alike so that the direction stays. */
    Map<String, Double> levels(Wanted wanted) {
        double[] aim = {
            wanted.surge(), wanted.sway(), wanted.heave(), 0, -wanted.pitch(), wanted.yaw()
        };
        for (int axis = 0; axis < 6; axis++) {
            aim[axis] *= most[axis] * weight[axis];
        }
        double[] thrusts = inverse.operate(aim);
        double largest = 1;
        for (double thrust : thrusts) {
            largest = Math.max(largest, Math.abs(thrust));
        }
        Map<String, Double> levels = new HashMap<>();
        for (int k = 0; k < thrusters.size(); k++) {
            Thruster thruster = thrusters.get(k);
            levels.put(thruster.propulsor().name(), thruster.level(thrusts[k] / largest));
        }
        return levels;
    }
}
