package org.auvsim.core.step;

import static org.auvsim.core.step.Paths.CURVE;
import static org.auvsim.core.step.Paths.END;
import static org.auvsim.core.step.Paths.START;

import org.auvsim.core.entity.Collidable;
import org.auvsim.core.volume.PairQueries;
import org.auvsim.core.volume.Pose;
import org.auvsim.core.volume.Separation;

import java.util.Arrays;

/**
 * The narrow phase of one lane: when two bodies first touch on their trajectories. What it finds
 * for a whole frame it keeps until the lanes are put together.
 */
final class Encounters implements ColumnGrid.Pairs {
    private final BodyTraits traits;
    private final Trajectories trajectories;
    private final double[] curve;
    private final ConservativeAdvancement shapes;
    private final EntityImpact entities;
    private final PairQueries queries;
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();
    private final Separation gap = new Separation();
    private final BodyCurve curveA = new BodyCurve();
    private final BodyCurve curveB = new BodyCurve();

    /**
     * In place of a time: two shapes touch or nearly do. When they meet takes long to find out
     * then, and of those that rest nobody asks.
     */
    static final double UNKNOWN = -1;

    private final SphereImpact spheres = new SphereImpact();
    private final double[] relative = new double[12];
    private final double[] cut = new double[12];
    private double[] times = new double[64];
    private int[] pairs = new int[128];
    private int count;

    Encounters(BodyTraits traits, Trajectories trajectories, PairQueries queries) {
        this.traits = traits;
        this.trajectories = trajectories;
        curve = trajectories.paths().curves();
        this.queries = queries;
        shapes = new ConservativeAdvancement(queries);
        entities = new EntityImpact(queries);
    }

    void clear() {
        count = 0;
    }

    @Override
    public void meet(int a, int b) {
        if (!traits.mayCollide(a, b)) {
            return;
        }
        if (traits.isSphere[a] && traits.isSphere[b]) {
            double t = first(a, b);
            if (t < Double.POSITIVE_INFINITY || areNear(a, b)) {
                add(t, a, b);
            }
        } else if (areNear(a, b)) {
            add(UNKNOWN, a, b);
        } else {
            double t = first(a, b);
            if (t < Double.POSITIVE_INFINITY) {
                add(t, a, b);
            }
        }
    }

    /** Whether two are so near each other at the frame's beginning that they may rest. */
    private boolean areNear(int a, int b) {
        int p = CURVE * a;
        int q = CURVE * b;
        double dx = curve[p] - curve[q];
        double dy = curve[p + 1] - curve[q + 1];
        double dz = curve[p + 2] - curve[q + 2];
        double reach = traits.radius[a] + traits.radius[b] + traits.nearness(a, b);
        if (dx * dx + dy * dy + dz * dz > reach * reach) {
            return false;
        }
        if (traits.isSphere[a] && traits.isSphere[b]) {
            return true;
        }
        trajectories.paths().pose(a, poseA);
        trajectories.paths().pose(b, poseB);
        return queries.distance(traits.volume[a], poseA, traits.volume[b], poseB, gap)
                <= traits.nearness(a, b);
    }

    /**
     * Offset (s) at which the two first touch while both are on their present segments; infinity if
     * they do not. Two that touch already are in contact at once if they approach.
     */
    double first(int a, int b) {
        double from = Math.max(curve[CURVE * a + START], curve[CURVE * b + START]);
        double to = Math.min(curve[CURVE * a + END], curve[CURVE * b + END]);
        if (!(from < to)) {
            return Double.POSITIVE_INFINITY;
        }
        if (!(traits.isSphere[a] && traits.isSphere[b])) {
            trajectories.paths().load(a, curveA);
            trajectories.paths().load(b, curveB);
            return shapes.first(curveA, traits.volume[a], curveB, traits.volume[b], from, to);
        }
        relativePath(a, b, from, to);
        double reach = traits.radius[a] + traits.radius[b];
        double s = spheres.first(relative, 0, reach, reach);
        return s < Double.POSITIVE_INFINITY ? from + s * (to - from) : s;
    }

    /**
     * The same for a body and what is none, such as a wave.
     *
     * @param epoch the world's time (s) at the frame's beginning
     */
    double first(int body, Collidable entity, double epoch) {
        double from = curve[CURVE * body + START];
        double to = curve[CURVE * body + END];
        trajectories.paths().load(body, curveA);
        return from < to
                ? entities.first(entity, epoch, curveA, traits.volume[body], from, to)
                : Double.POSITIVE_INFINITY;
    }

    private void relativePath(int a, int b, double from, double to) {
        int p = CURVE * a;
        int q = CURVE * b;
        if (curve[p + START] == curve[q + START] && curve[p + END] == curve[q + END]) {
            for (int k = 0; k < 12; k++) {
                relative[k] = curve[p + k] - curve[q + k];
            }
            return;
        }
        piece(a, from, to, relative);
        piece(b, from, to, cut);
        for (int k = 0; k < 12; k++) {
            relative[k] -= cut[k];
        }
    }

    /** The control points of that piece of a body's curve which lies between two offsets. */
    private void piece(int body, double from, double to, double[] points) {
        int at = CURVE * body;
        double start = curve[at + START];
        double end = curve[at + END];
        System.arraycopy(curve, at, points, 0, 12);
        double length = end - start;
        if (from > start) {
            cutBefore(points, (from - start) / length);
        }
        if (to < end) {
            cutBehind(points, (to - from) / (end - from));
        }
    }

    /** Keeps the part behind a share of the curve (de Casteljau). */
    private static void cutBefore(double[] p, double s) {
        for (int axis = 0; axis < 3; axis++) {
            double b0 = p[axis] + s * (p[axis + 3] - p[axis]);
            double b1 = p[axis + 3] + s * (p[axis + 6] - p[axis + 3]);
            double b2 = p[axis + 6] + s * (p[axis + 9] - p[axis + 6]);
            double c0 = b0 + s * (b1 - b0);
            double c1 = b1 + s * (b2 - b1);
            p[axis] = c0 + s * (c1 - c0);
            p[axis + 3] = c1;
            p[axis + 6] = b2;
        }
    }

    /** Keeps the part before a share of the curve. */
    private static void cutBehind(double[] p, double s) {
        for (int axis = 0; axis < 3; axis++) {
            double b0 = p[axis] + s * (p[axis + 3] - p[axis]);
            double b1 = p[axis + 3] + s * (p[axis + 6] - p[axis + 3]);
            double b2 = p[axis + 6] + s * (p[axis + 9] - p[axis + 6]);
            double c0 = b0 + s * (b1 - b0);
            double c1 = b1 + s * (b2 - b1);
            p[axis + 3] = b0;
            p[axis + 6] = c0;
            p[axis + 9] = c0 + s * (c1 - c0);
        }
    }

    private void add(double t, int a, int b) {
        if (count == times.length) {
            times = Arrays.copyOf(times, 2 * count);
            pairs = Arrays.copyOf(pairs, 4 * count);
        }
        times[count] = t;
        pairs[2 * count] = a;
        pairs[2 * count + 1] = b;
        count++;
    }

    int count() {
        return count;
    }

    double time(int k) {
        return times[k];
    }

    int firstOf(int k) {
        return pairs[2 * k];
    }

    int secondOf(int k) {
        return pairs[2 * k + 1];
    }
}
