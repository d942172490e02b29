package org.auvsim.diagnosis.cause;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.EigenDecomposition;
import org.auvsim.core.math.Mat3;

/** Changes of a tensor of inertia along its own axes. */
final class PrincipalInertia {
    private PrincipalInertia() {}

    /**
     * The tensor with each principal moment times a factor: that about the principal axis which is
     * nearest to x times the first, and so on.
     */
    static Mat3 scaled(Mat3 tensor, double x, double y, double z) {
        if (tensor.xy() == 0 && tensor.xz() == 0 && tensor.yz() == 0) {
            return Mat3.diagonal(x * tensor.xx(), y * tensor.yy(), z * tensor.zz());
        }
        double[] factors = {x, y, z};
        EigenDecomposition axes =
                new EigenDecomposition(
                        new Array2DRowRealMatrix(
                                new double[][] {
                                    {tensor.xx(), tensor.xy(), tensor.xz()},
                                    {tensor.xy(), tensor.yy(), tensor.yz()},
                                    {tensor.xz(), tensor.yz(), tensor.zz()}
                                }));
        int[] own = nearest(axes);
        double[][] sum = new double[3][3];
        for (int k = 0; k < 3; k++) {
            double moment = factors[own[k]] * axes.getRealEigenvalue(k);
            double[] axis = axes.getEigenvector(k).toArray();
            for (int i = 0; i < 3; i++) {
                for (int j = 0; j < 3; j++) {
                    sum[i][j] += moment * axis[i] * axis[j];
                }
            }
        }
        return new Mat3(
                sum[0][0], sum[0][1], sum[0][2], sum[0][1], sum[1][1], sum[1][2], sum[0][2],
                sum[1][2], sum[2][2]);
    }

    /** For each principal axis the body axis that it stands for: together they agree most. */
    private static int[] nearest(EigenDecomposition axes) {
        int[][] orders = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
        int[] best = orders[0];
        double most = -1;
        for (int[] order : orders) {
            double agreement = 0;
            for (int k = 0; k < 3; k++) {
                agreement += Math.abs(axes.getEigenvector(k).getEntry(order[k]));
            }
            if (agreement > most) {
                most = agreement;
                best = order;
            }
        }
        return best;
    }
}
