package org.auvsim.core.dynamics;

import static org.auvsim.core.entity.BodyState.LX;
import static org.auvsim.core.entity.BodyState.PX;

import org.auvsim.core.entity.Block;

/**
 * How stiff the forces on a body are, from the first three stages of a Runge-Kutta step (as Hairer
 * &amp; Wanner, Solving Ordinary Differential Equations II, 1996, IV.2, do with other stages).
 *
 * <p>With dP/dt = -c P the rates k of the stages give z = -2 (k3 - k2).(k2 - k1)/|k2 - k1|^2 = c
 * dt. The relative error of a step is z^5/120 and below 1 % up to z = 1; from z = 2.8 on the method
 * diverges. A force that jumps and stays there has k3 = k2 and so z = 0.
 */
final class Stiffness {
    /** Beyond this z the first two stages must tell the same. */
    private static final double JUMP = 32;

    /** Changes of a momentum below this share are rounding. */
    private static final double ROUNDING = 1e-6;

    /**
     * A stage that changes a momentum by less than this share does no harm: where a force is just
     * at its extreme, stages differ by what is small anyway.
     */
    private static final double HARMLESS = 0.01;

    /**
     * What counts as speed at least (m/s): at rest, where forces balance, stages differ by rounding
     * and by the partners' motion alone. What is unstable soon exceeds it.
     */
    private static final double REST = 1e-2;

    private Stiffness() {}

    /** Writes for each body into how many parts the step of {@code dt} (s) should be cut. */
    static void estimate(Block b, double[][] start, double[][] sum, double dt) {
        for (int i = 0; i < b.count; i++) {
            double z = stiffness(b, i, start, sum, dt, PX);
            if (b.turns()) {
                z = Math.max(z, stiffness(b, i, start, sum, dt, LX));
            }
            b.setSubSteps(i, parts(z));
        }
    }

    /** The least power of 2 that is not below z. */
    private static int parts(double z) {
        int parts = 1;
        while (parts < z && parts < Block.MOST_SUB_STEPS) {
            parts *= 2;
        }
        return parts;
    }

    /**
     * z of one of the momenta; after the third evaluation, when the state stands at start + k2 dt/2
     * and the sum at start + k1 dt/6 + k2 dt/3.
     */
    private static double stiffness(
            Block b, int i, double[][] start, double[][] sum, double dt, int column) {
        double across = 0;
        double early = 0;
        double late = 0;
        double first = 0;
        double momentum = 0;
        for (int c = column; c < column + 3; c++) {
            double p = start[c][i];
            double k2 = 2 / dt * (b.state[c][i] - p);
            double k1 = 6 / dt * (sum[c][i] - p) - 2 * k2;
            double before = k2 - k1;
            double after = b.rate[c][i] - k2;
            across -= after * before;
            early += before * before;
            late += after * after;
            first += k1 * k1;
            momentum += p * p;
        }
        double scale = Math.sqrt(momentum) + dt * Math.sqrt(first) + REST * b.mass[i];
        if (across <= 0
                || dt * Math.sqrt(early) <= ROUNDING * scale
                || dt * Math.sqrt(late) <= HARMLESS * scale) {
            return 0;
        }
        double z = 2 * across / early;
        // Of a stiff force each stage's change is z/2 times the last one; of one that jumps, or is
        // changed by something else such as a partner's fall, only the last is large.
        return z > JUMP ? Math.min(z, 2 * Math.sqrt(early / first)) : z;
    }
}
