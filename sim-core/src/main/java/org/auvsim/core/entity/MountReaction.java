package org.auvsim.core.entity;

import org.auvsim.core.math.Vec3;

/**
 * The wrench by which a mount keeps a body to its free directions. With momenta h = M nu - MA nu_c
 * in body axes, the free directions C and all other forces f (those of the momenta that are carried
 * along included), the motion obeys
 *
 * <pre>dh/dt + [w] h = f + f_c,    nu = C s,    C^T f_c = 0</pre>
 *
 * <p>which is solved for the change of the free speeds s first (Fossen 2021, section 3.3;
 * Featherstone, Rigid Body Dynamics Algorithms, 2008, section 3.4).
 */
public final class MountReaction {
    private final Block block;
    private final int i;
    private final SpatialInertia inertia;
    private final double[][] free;

    private MountReaction(Block block, int i, SpatialInertia inertia, FreeDirections directions) {
        this.block = block;
        this.i = i;
        this.inertia = inertia;
        free = new double[directions.count()][];
        for (int k = 0; k < free.length; k++) {
            double[] inWorld = directions.get(k);
            free[k] = six(block.toBody(i, linear(inWorld)), block.toBody(i, angular(inWorld)));
        }
    }

    /**
     * That on body {@code i}, zero if it has no mount; all velocities and the forces and torques
     * that act on it are in the block.
     *
     * @param waterAcceleration of the water that the moving origin meets (m/s^2, world)
     */
    public static Wrench of(Block block, int i, SpatialInertia inertia, Vec3 waterAcceleration) {
        FreeDirections free = inertia.free;
        return free != null
                ? new MountReaction(block, i, inertia, free).solve(waterAcceleration)
                : Wrench.ZERO;
    }

    private Wrench solve(Vec3 waterAcceleration) {
        double[] lacking = lacking(waterAcceleration);
        int n = free.length;
        double[] reduced = new double[36];
        double[] change = new double[6];
        for (int k = 0; k < n; k++) {
            double[] momentum = times(inertia.whole, free[k]);
            for (int j = 0; j < n; j++) {
                reduced[6 * j + k] = dot(free[j], momentum);
            }
            change[k] = -dot(free[k], lacking);
        }
        SpatialMatrix.factor(reduced, 0, n);
        SpatialMatrix.solve(reduced, 0, n, change, 0);
        double[] acceleration = new double[6];
        for (int k = 0; k < n; k++) {
            for (int c = 0; c < 6; c++) {
                acceleration[c] += free[k][c] * change[k];
            }
        }
        double[] reaction = sum(lacking, 1, times(inertia.whole, acceleration));
        return new Wrench(block.toWorld(i, linear(reaction)), block.toWorld(i, angular(reaction)));
    }

    /** What the mount would exert if the free speeds did not change (body axes). */
    private double[] lacking(Vec3 waterAcceleration) {
        Vec3 w = new Vec3(block.bodyWx[i], block.bodyWy[i], block.bodyWz[i]);
        Vec3 water = block.toBody(i, block.waterVelocity(i));
        double[] motion = six(block.toBody(i, block.velocity(i)), w);
        double[] flow = six(water, Vec3.ZERO);
        double[] flowChange =
                six(block.toBody(i, waterAcceleration).minus(w.cross(water)), Vec3.ZERO);
        double[] momentum = sum(times(inertia.whole, motion), -1, times(inertia.added, flow));
        double[] change =
                sum(times(inertia.whole, turning(w, motion)), 1, times(inertia.added, flowChange));
        return sum(sum(turning(w, momentum), -1, change), -1, others());
    }

    /** What else acts: forces, and torques with those of the momenta that are carried along. */
    private double[] others() {
        Vec3 force = new Vec3(block.fx[i], block.fy[i], block.fz[i]);
        Vec3 torque =
                new Vec3(
                        block.tx[i] + block.carriedTx[i],
                        block.ty[i] + block.carriedTy[i],
                        block.tz[i] + block.carriedTz[i]);
        return six(block.toBody(i, force), block.toBody(i, torque));
    }

    /** w x the linear and w x the angular part. */
    private static double[] turning(Vec3 w, double[] m) {
        return six(w.cross(linear(m)), w.cross(angular(m)));
    }

    private static Vec3 linear(double[] m) {
        return new Vec3(m[0], m[1], m[2]);
    }

    private static Vec3 angular(double[] m) {
        return new Vec3(m[3], m[4], m[5]);
    }

    private static double[] six(Vec3 linear, Vec3 angular) {
        return new double[] {
            linear.x(), linear.y(), linear.z(), angular.x(), angular.y(), angular.z()
        };
    }

    private static double[] sum(double[] a, double factor, double[] b) {
        double[] sum = new double[6];
        for (int c = 0; c < 6; c++) {
            sum[c] = a[c] + factor * b[c];
        }
        return sum;
    }

    private static double dot(double[] a, double[] b) {
        double sum = 0;
        for (int c = 0; c < 6; c++) {
            sum += a[c] * b[c];
        }
        return sum;
    }

    private static double[] times(double[] matrix, double[] m) {
        double[] product = new double[6];
        for (int row = 0; row < 6; row++) {
            for (int c = 0; c < 6; c++) {
                product[row] += matrix[6 * row + c] * m[c];
            }
        }
        return product;
    }
}
