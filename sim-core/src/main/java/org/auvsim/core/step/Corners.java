package org.auvsim.core.step;

import org.auvsim.core.volume.Manifold;

/**
 * Chooses four points of a flat contact that hold as much as all of them: its corners. Edges that
 * nearly coincide cut each other anywhere; such points come and go and only make solving harder.
 * Corners that are far off, such as those on top of a box that slides, are no part of the contact.
 */
final class Corners {
    private static final int MOST = 4;

    /** Normals whose cosine is above this belong to one flat contact. */
    private static final double FLAT = 0.999;

    /** Points whose gaps differ by less than this share of the contact's width touch together. */
    private static final double TOGETHER = 0.1;

    /** Gaps of one plane lie on a plane to within this share of the contact's width. */
    private static final double BULGE = 1e-6;

    private final int[] chosen = new int[MOST];
    private final int[] near = new int[Manifold.MAXIMUM];
    private int nearCount;

    /** Numbers of the chosen points; {@link #choose} tells how many. */
    int[] chosen() {
        return chosen;
    }

    /** Chooses among the points of a contact; -1 if all are to be kept. */
    int choose(Manifold m) {
        if (m.count <= MOST || !isFlat(m)) {
            return -1;
        }
        findNear(m);
        if (nearCount < 3) {
            return -1;
        }
        if (nearCount <= MOST) {
            System.arraycopy(near, 0, chosen, 0, nearCount);
            return nearCount;
        }
        chosen[0] = outermost(m);
        chosen[1] = farthest(m, m.x[chosen[0]], m.y[chosen[0]], m.z[chosen[0]]);
        chosen[2] = mostAside(m, 1);
        chosen[3] = mostAside(m, -1);
        int count = 2;
        for (int k = 2; k < MOST; k++) {
            if (chosen[k] >= 0) {
                chosen[count++] = chosen[k];
            }
        }
        return bulges(m, count) ? -1 : count;
    }

    /**
     * Whether a point lies deeper than a plane would have it at which the chosen ones touch: it
     * carries what they do not, as a ball does that stands out of a box's bottom.
     */
    private boolean bulges(Manifold m, int count) {
        int a = chosen[0];
        int b = chosen[1];
        double dx = m.x[b] - m.x[a];
        double dy = m.y[b] - m.y[a];
        double dz = m.z[b] - m.z[a];
        double squared = dx * dx + dy * dy + dz * dz;
        double along = m.gap[b] - m.gap[a];
        double aside = 0;
        if (count > 2) {
            int c = chosen[2];
            double t = along(m, a, c, dx, dy, dz) / squared;
            aside = (m.gap[c] - m.gap[a] - t * along) / aside(m, a, c, dx, dy, dz);
        }
        boolean any = false;
        for (int i = 0; i < nearCount; i++) {
            int k = near[i];
            double plane =
                    m.gap[a]
                            + along(m, a, k, dx, dy, dz) / squared * along
                            + aside(m, a, k, dx, dy, dz) * aside;
            any |= m.gap[k] < plane - BULGE * Math.sqrt(squared);
        }
        return any;
    }

    /** How far point k lies from point a along a direction, times the direction's length. */
    private static double along(Manifold m, int a, int k, double dx, double dy, double dz) {
        return dx * (m.x[k] - m.x[a]) + dy * (m.y[k] - m.y[a]) + dz * (m.z[k] - m.z[a]);
    }

    /** How far point k lies to one side of point a, seen along a direction, times its length. */
    private static double aside(Manifold m, int a, int k, double dx, double dy, double dz) {
        return (dy * m.nz[a] - dz * m.ny[a]) * (m.x[k] - m.x[a])
                + (dz * m.nx[a] - dx * m.nz[a]) * (m.y[k] - m.y[a])
                + (dx * m.ny[a] - dy * m.nx[a]) * (m.z[k] - m.z[a]);
    }

    private static boolean isFlat(Manifold m) {
        for (int k = 1; k < m.count; k++) {
            double cosine = m.nx[0] * m.nx[k] + m.ny[0] * m.ny[k] + m.nz[0] * m.nz[k];
            if (cosine < FLAT) {
                return false;
            }
        }
        return true;
    }

    /** Finds the points that touch together with the deepest one. */
    private void findNear(Manifold m) {
        double width = 0;
        for (int k = 0; k < m.count; k++) {
            double dx = m.x[k] - m.x[0];
            double dy = m.y[k] - m.y[0];
            double dz = m.z[k] - m.z[0];
            width = Math.max(width, dx * dx + dy * dy + dz * dz);
        }
        double most = m.leastGap() + TOGETHER * Math.sqrt(width);
        nearCount = 0;
        for (int k = 0; k < m.count; k++) {
            if (m.gap[k] <= most) {
                near[nearCount++] = k;
            }
        }
    }

    /** A corner in any case: the point that is farthest from the middle of all. */
    private int outermost(Manifold m) {
        double x = 0;
        double y = 0;
        double z = 0;
        for (int i = 0; i < nearCount; i++) {
            x += m.x[near[i]] / nearCount;
            y += m.y[near[i]] / nearCount;
            z += m.z[near[i]] / nearCount;
        }
        return farthest(m, x, y, z);
    }

    private int farthest(Manifold m, double x, double y, double z) {
        int best = near[0];
        double most = -1;
        for (int i = 0; i < nearCount; i++) {
            int k = near[i];
            double dx = m.x[k] - x;
            double dy = m.y[k] - y;
            double dz = m.z[k] - z;
            double squared = dx * dx + dy * dy + dz * dz;
            if (squared > most) {
                most = squared;
                best = k;
            }
        }
        return best;
    }

    /** The point farthest to one side of the line through the first two; -1 if there is none. */
    private int mostAside(Manifold m, double side) {
        int a = chosen[0];
        int b = chosen[1];
        double dx = m.x[b] - m.x[a];
        double dy = m.y[b] - m.y[a];
        double dz = m.z[b] - m.z[a];
        int best = -1;
        double most = 1e-6 * (dx * dx + dy * dy + dz * dz);
        for (int i = 0; i < nearCount; i++) {
            int k = near[i];
            double aside = side * aside(m, a, k, dx, dy, dz);
            if (aside > most) {
                most = aside;
                best = k;
            }
        }
        return best;
    }
}
