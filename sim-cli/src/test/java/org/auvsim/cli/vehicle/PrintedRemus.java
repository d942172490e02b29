package org.auvsim.cli.vehicle;

/**
 * The REMUS as it is printed: the six equations of Prestero (2001, chapter 4) in velocities, axes
 * forward, starboard, down, with the coefficients of his appendices, integrated on its own.
 */
final class PrintedRemus {
    static final int U = 0;
    static final int V = 1;
    static final int W = 2;
    static final int P = 3;
    static final int Q = 4;
    static final int R = 5;
    static final int DEPTH = 6;
    static final int ROLL = 7;
    static final int PITCH = 8;
    private static final double WEIGHT = 299;
    private static final double BUOYANCY = 306;
    private static final double MASS = 30.48;
    private static final double ZG = 0.0196;

    /** Velocities (m/s, rad/s), depth (m), roll and pitch (rad). */
    final double[] state = new double[9];

    private final double rudder;
    private final double stern;
    private final boolean planar;

    /**
     * Under way at 1.54 m/s.
     *
     * @param planar whether heave, roll and pitch are held
     */
    PrintedRemus(double rudder, double stern, boolean planar) {
        this.rudder = rudder;
        this.stern = stern;
        this.planar = planar;
        state[U] = 1.54;
    }

    /** A step of the classical Runge-Kutta method (s). */
    void advance(double step) {
        double[] a = rates(state);
        double[] b = rates(plus(a, step / 2));
        double[] c = rates(plus(b, step / 2));
        double[] d = rates(plus(c, step));
        for (int i = 0; i < state.length; i++) {
            state[i] += step / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
        }
    }

    private double[] plus(double[] rate, double step) {
        double[] sum = state.clone();
        for (int i = 0; i < sum.length; i++) {
            sum[i] += step * rate[i];
        }
        return sum;
    }

    private double[] rates(double[] s) {
        double[] f = forces(s);
        double u = s[U];
        double v = s[V];
        double w = s[W];
        double p = s[P];
        double q = s[Q];
        double r = s[R];
        double[][] m = {
            {MASS + 0.930, 0, 0, 0, MASS * ZG, 0},
            {0, MASS + 35.5, 0, -MASS * ZG, 0, -1.93},
            {0, 0, MASS + 35.5, 0, 1.93, 0},
            {0, -MASS * ZG, 0, 0.177 + 0.0704, 0, 0},
            {MASS * ZG, 0, 1.93, 0, 3.45 + 4.88, 0},
            {0, -1.93, 0, 0, 0, 3.45 + 4.88}
        };
        f[U] -= MASS * (-v * r + w * q + ZG * p * r);
        f[V] -= MASS * (-w * p + u * r + ZG * q * r);
        f[W] -= MASS * (-u * q + v * p - ZG * (p * p + q * q));
        f[P] -= (3.45 - 3.45) * q * r - MASS * ZG * (-w * p + u * r);
        f[Q] -= (0.177 - 3.45) * r * p + MASS * ZG * (-v * r + w * q);
        f[R] -= (3.45 - 0.177) * p * q;
        for (int i = 0; planar && i < 6; i++) {
            if (i == W || i == P || i == Q) {
                m[i] = new double[6];
                m[i][i] = 1;
                f[i] = 0;
            }
        }
        double[] rates = new double[9];
        System.arraycopy(solved(m, f), 0, rates, 0, 6);
        double roll = s[ROLL];
        double pitch = s[PITCH];
        rates[DEPTH] =
                -u * Math.sin(pitch)
                        + v * Math.cos(pitch) * Math.sin(roll)
                        + w * Math.cos(pitch) * Math.cos(roll);
        rates[ROLL] = p + (q * Math.sin(roll) + r * Math.cos(roll)) * Math.tan(pitch);
        rates[PITCH] = q * Math.cos(roll) - r * Math.sin(roll);
        return rates;
    }

    private double[] forces(double[] s) {
        double u = s[U];
        double v = s[V];
        double w = s[W];
        double p = s[P];
        double q = s[Q];
        double r = s[R];
        double cosine = Math.cos(s[PITCH]);
        double heavy = WEIGHT - BUOYANCY;
        return new double[] {
            -heavy * Math.sin(s[PITCH])
                    - 1.62 * u * Math.abs(u)
                    - 35.5 * w * q
                    - 1.93 * q * q
                    + 35.5 * v * r
                    - 1.93 * r * r
                    + 3.86,
            heavy * cosine * Math.sin(s[ROLL])
                    - 1310 * v * Math.abs(v)
                    + 0.632 * r * Math.abs(r)
                    - 28.6 * u * v
                    + 5.22 * u * r
                    + 35.5 * w * p
                    + 1.93 * p * q
                    + 9.64 * u * u * rudder,
            heavy * cosine * Math.cos(s[ROLL])
                    - 131 * w * Math.abs(w)
                    - 0.632 * q * Math.abs(q)
                    - 28.6 * u * w
                    - 5.22 * u * q
                    - 35.5 * v * p
                    + 1.93 * r * p
                    - 9.64 * u * u * stern,
            -ZG * WEIGHT * cosine * Math.sin(s[ROLL]) - 0.130 * p * Math.abs(p) - 0.543,
            -ZG * WEIGHT * Math.sin(s[PITCH])
                    + 3.18 * w * Math.abs(w)
                    - 188 * q * Math.abs(q)
                    + 24.0 * u * w
                    - 2.00 * u * q
                    - 1.93 * v * p
                    + 4.86 * r * p
                    - 6.15 * u * u * stern,
            -3.18 * v * Math.abs(v)
                    - 94.0 * r * Math.abs(r)
                    - 24.0 * u * v
                    - 2.00 * u * r
                    - 1.93 * w * p
                    - 4.86 * p * q
                    - 6.15 * u * u * rudder
        };
    }

    /** Gaussian elimination with pivots. */
    private static double[] solved(double[][] m, double[] f) {
        int n = f.length;
        for (int k = 0; k < n; k++) {
            int pivot = k;
            for (int i = k + 1; i < n; i++) {
                pivot = Math.abs(m[i][k]) > Math.abs(m[pivot][k]) ? i : pivot;
            }
            double[] row = m[k];
            m[k] = m[pivot];
            m[pivot] = row;
            double value = f[k];
            f[k] = f[pivot];
            f[pivot] = value;
            for (int i = k + 1; i < n; i++) {
                double factor = m[i][k] / m[k][k];
                for (int j = k; j < n; j++) {
                    m[i][j] -= factor * m[k][j];
                }
                f[i] -= factor * f[k];
            }
        }
        for (int k = n - 1; k >= 0; k--) {
            for (int j = k + 1; j < n; j++) {
                f[k] -= m[k][j] * f[j];
            }
            f[k] /= m[k][k];
        }
        return f;
    }
}
