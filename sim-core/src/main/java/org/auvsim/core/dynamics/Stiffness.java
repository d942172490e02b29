package org.auvsim.core.dynamics;

import static org.auvsim.core.entity.BodyState.LX;
import static org.auvsim.core.entity.BodyState.PX;

import org.auvsim.core.entity.Block;

import java.util.Arrays;

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

    /** Where in the block's scratch the sums of a body's three components stand. */
    private static final int ACROSS = 0;

    private static final int EARLY = 1;
    private static final int LATE = 2;
    private static final int FIRST = 3;
    private static final int MOMENTUM = 4;
    private static final int SUMS = 5;
    private static final int Z = 5;

    private Stiffness() {}

    /** Writes for each body into how many parts the step of {@code dt} (s) should be cut. */
    static void estimate(Block b, double[][] start, double[][] sum, double dt) {
        double[] z = b.scratch[Z];
        Arrays.fill(z, 0, b.count, 0);
        compare(b, start, sum, dt, PX, z);
        if (b.turns()) {
            compare(b, start, sum, dt, LX, z);
        }
        for (int i = 0; i < b.count; i++) {
            b.setSubSteps(i, parts(z[i]));
        }
    }

    /** The least power of 2 that is not below z, but for rounding: of round numbers z is one. */
    private static int parts(double z) {
        int parts = 1;
        while (parts < (1 - ROUNDING) * z && parts < Block.MOST_SUB_STEPS) {
            parts *= 2;
        }
        return parts;
    }

    /**
     * Raises z to that of one of the momenta; after the third evaluation, when the state stands at
     * start + k2 dt/2 and the sum at start + k1 dt/6 + k2 dt/3.
     */
    private static void compare(
            Block b, double[][] start, double[][] sum, double dt, int column, double[] z) {
        double[][] s = b.scratch;
        for (int k = 0; k < SUMS; k++) {
            Arrays.fill(s[k], 0, b.count, 0);
        }
        for (int c = column; c < column + 3; c++) {
            addChanges(b.count, s, start[c], b.state[c], sum[c], b.rate[c], dt);
            addSizes(b.count, s, start[c], b.state[c], sum[c], dt);
        }
        double harmless = HARMLESS * HARMLESS / (dt * dt);
        for (int i = 0; i < b.count; i++) {
            // Most bodies are told by this alone; what scale adds makes the bound only larger.
            if (s[ACROSS][i] > 0 && s[LATE][i] > harmless * s[MOMENTUM][i]) {
                z[i] = Math.max(z[i], stiffness(s, i, dt, b.mass[i]));
            }
        }
    }

    private static void addChanges(
            int count,
            double[][] sums,
            double[] start,
            double[] state,
            double[] sum,
            double[] rate,
            double dt) {
        double[] across = sums[ACROSS];
        double[] early = sums[EARLY];
        double[] late = sums[LATE];
        double twice = 2 / dt;
        double sixfold = 6 / dt;
        for (int i = 0; i < count; i++) {
            double k2 = twice * (state[i] - start[i]);
            double before = 3 * k2 - sixfold * (sum[i] - start[i]);
            double after = rate[i] - k2;
            across[i] -= after * before;
            early[i] += before * before;
            late[i] += after * after;
        }
    }

    private static void addSizes(
            int count, double[][] sums, double[] start, double[] state, double[] sum, double dt) {
        double[] first = sums[FIRST];
        double[] momentum = sums[MOMENTUM];
        double twice = 2 / dt;
        double sixfold = 6 / dt;
        for (int i = 0; i < count; i++) {
            double k1 = sixfold * (sum[i] - start[i]) - 2 * twice * (state[i] - start[i]);
            first[i] += k1 * k1;
            momentum[i] += start[i] * start[i];
        }
    }

    private static double stiffness(double[][] sums, int i, double dt, double mass) {
        double early = sums[EARLY][i];
        double late = sums[LATE][i];
        double first = sums[FIRST][i];
        double scale = Math.sqrt(sums[MOMENTUM][i]) + dt * Math.sqrt(first) + REST * mass;
        if (dt * Math.sqrt(early) <= ROUNDING * scale || dt * Math.sqrt(late) <= HARMLESS * scale) {
            return 0;
        }
        double z = 2 * sums[ACROSS][i] / early;
        // Of a stiff force each stage's change is z/2 times the last one; of one that jumps, or is
        // changed by something else such as a partner's fall, only the last is large.
        return z > JUMP ? Math.min(z, 2 * Math.sqrt(early / first)) : z;
    }
}
