package org.auvsim.experiments.vehicle;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.MotionAxis;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;

/**
 * What forces and torques the propulsors can make together (Fossen 2021, section 11.2): the columns
 * of T are force and torque of each of them for one newton of thrust.
 *
 * @param rank of T: on how many ways of motion they act independently
 * @param free the axes on which they can push without pushing on any other
 */
record ThrustAllocation(int rank, List<MotionAxis> free) {
    private static final double ROUNDING = 1e-9;

    static ThrustAllocation of(List<Propulsor> propulsors) {
        if (propulsors.isEmpty()) {
            return new ThrustAllocation(0, List.of());
        }
        RealMatrix t = new Array2DRowRealMatrix(6, propulsors.size());
        for (int k = 0; k < propulsors.size(); k++) {
            Propulsor p = propulsors.get(k);
            Vec3 turn =
                    p.position().cross(p.direction()).plus(p.direction().times(p.reactionTorque()));
            Vec3 push = p.direction();
            t.setColumn(
                    k, new double[] {push.x(), push.y(), push.z(), turn.x(), turn.y(), turn.z()});
        }
        SingularValueDecomposition parts = new SingularValueDecomposition(t);
        double[] values = parts.getSingularValues();
        int rank = 0;
        while (rank < values.length && values[rank] > ROUNDING * values[0]) {
            rank++;
        }
        return new ThrustAllocation(rank, free(parts.getU(), rank));
    }

    /** The unit vectors that lie in the space of the first columns of U. */
    private static List<MotionAxis> free(RealMatrix u, int rank) {
        List<MotionAxis> free = new ArrayList<>();
        for (MotionAxis axis : MotionAxis.values()) {
            double inside = 0;
            for (int k = 0; k < rank; k++) {
                inside += u.getEntry(axis.index(), k) * u.getEntry(axis.index(), k);
            }
            if (inside > 1 - ROUNDING) {
                free.add(axis);
            }
        }
        return free;
    }
}
