package org.auvsim.core.step;

import org.auvsim.core.volume.PairQueries;
import org.auvsim.core.volume.Pose;
import org.auvsim.core.volume.Separation;
import org.auvsim.core.volume.Volume;

/**
 * First contact of two volumes of any kind on their curves, without a sampled instant: conservative
 * advancement (Mirtich 1996, section 2.3.2). From an instant at which they are apart it steps to a
 * later one up to which they cannot touch, until the gap is {@value #CONTACT} of the smaller
 * bounding radius or the time is over. Three bounds hold; the longest step of them is taken.
 *
 * <ol>
 *   <li>The gap d falls no faster than the volumes near each other: d / closing.
 *   <li>Let n be the direction of the gap and g the gap between the planes across n that the volumes
 *       touch from either side. While g &gt; 0 they are apart, whatever else they do, and g falls no
 *       faster than points near each other along n: g / closing along n.
 *   <li>g is the least of all distances along n between a point of one and a point of the other. If
 *       each of these has a second derivative of at most m and is g0 or more at one instant and g1
 *       or more another h later, then it is at least min(g0, g1) - m h^2 / 8 all the time between.
 *       So min(g0, g1) &gt;= m h^2 / 8 proves that they stay apart. Near a contact what remains of
 *       the gap is of the order of its square.
 * </ol>
 *
 * <p>Convex volumes take few steps. Where g is not positive, as between the prongs of a compound or
 * over hills, only the first bound is left.
 *
 * <p>Holds scratch: one for each thread. Allocates nothing after construction.
 */
final class ConservativeAdvancement {
    /**
     * A gap below this share of the smaller bounding radius is a contact: far above the rounding of
     * distances, far below the 1e-9 that bodies may overlap.
     */
    static final double CONTACT = 1e-10;

    /** Two that touch at the start may overlap by this many contact gaps more while they part. */
    private static final double SAG = 4;

    /** Share of the contact gap by which the gap has to fall to count as an approach. */
    private static final double FALL = 0.01;

    /** Coordinates are known to this share of their size. */
    private static final double ROUNDING = 0x1p-49;

    private static final int STEPS = 4_000;
    private static final int TRIALS = 8;
    private static final int STEPS_FOR_ONE_BOUND = 16;

    private final PairQueries queries;
    private final RelativeMotion motion = new RelativeMotion();
    private final Separation gap = new Separation();
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();
    private final Pose trialA = new Pose();
    private final Pose trialB = new Pose();

    ConservativeAdvancement(PairQueries queries) {
        this.queries = queries;
    }

    /**
     * First time from {@code t0} to {@code t1} (s), both on both curves, at which the volumes touch:
     * the gap is then above 0 and no more than {@value #CONTACT} of the smaller bounding radius;
     * infinity if they do not.
     *
     * <p>Volumes that touch or overlap at {@code t0} are in contact there if they get nearer; if they
     * part, the first contact after that counts. After {@value #STEPS} steps the time that has been
     * reached is given as a contact, since up to there and no farther the volumes are known to be
     * apart: too early is safe, as a response to a contact without approach changes nothing.
     *
     * <p>A volume without bounds (half-space, height map) must not turn.
     */
    double first(BodyCurve a, Volume va, BodyCurve b, Volume vb, double t0, double t1) {
        double t = parted(a, va, b, vb, t0, t1);
        double touch = touch(va, vb);
        double d = gap.distance;
        double until = t;
        for (int step = 0; step < STEPS && t < t1 && d > touch; step++) {
            if (t >= until || step % STEPS_FOR_ONE_BOUND == 0) {
                until = motion.look(a, va, b, vb, t, t1);
            }
            double h = safeStep(a, va, b, vb, t, until, d);
            double next = h < until - t ? t + h : until;
            if (next >= t1) {
                return Double.POSITIVE_INFINITY;
            }
            if (next == t) {
                return t;
            }
            d = distance(a, va, b, vb, next);
            t = next;
        }
        return t < t1 ? t : Double.POSITIVE_INFINITY;
    }

    /**
     * The time, {@code t0} if they are apart there, at which volumes that touch have parted beyond
     * the contact gap; a time at which they are in contact if they get nearer before. The gap and
     * the poses are then those of that time.
     */
    private double parted(BodyCurve a, Volume va, BodyCurve b, Volume vb, double t0, double t1) {
        double t = t0;
        double d = distance(a, va, b, vb, t);
        double touch = touch(va, vb);
        double least = d - FALL * touch;
        double until = t0;
        for (int step = 0; step < STEPS && t < t1 && d <= 2 * touch; step++) {
            if (t >= until) {
                until = motion.look(a, va, b, vb, t, t1);
            }
            double h = Math.min(partingStep(touch, t - t0, d), until - t);
            double shortest = SAG * touch / motion.closing();
            d = distance(a, va, b, vb, t + h);
            while (d < least && h > shortest) {
                h /= 4;
                d = distance(a, va, b, vb, t + h);
            }
            if (d < least) {
                distance(a, va, b, vb, t);
                return t;
            }
            t = h < until - t ? t + h : until;
        }
        return t;
    }

    /** The gap (m) at which these volumes, where they now are, are in contact. */
    private double touch(Volume va, Volume vb) {
        double size = Math.min(va.boundingRadius(), vb.boundingRadius());
        double far = Math.max(Math.abs(poseA.x), Math.max(Math.abs(poseA.y), Math.abs(poseA.z)));
        return Math.max(CONTACT * size, ROUNDING * far);
    }

    private double distance(BodyCurve a, Volume va, BodyCurve b, Volume vb, double t) {
        a.poseAt(t, poseA);
        b.poseAt(t, poseB);
        return queries.distance(va, poseA, vb, poseB, gap);
    }

    /** A step (s) during which volumes that touch overlap by no more than the sag, if they part. */
    private double partingStep(double touch, double since, double d) {
        double bend = motion.bend(gap.nx, gap.ny, gap.nz);
        double h = bend > 0 ? Math.sqrt(8 * SAG * touch / bend) : Double.POSITIVE_INFINITY;
        // What overlaps deeper than contacts do was put there; it has no gap to keep.
        return d < -SAG * touch ? Math.max(h, since) : h;
    }

    /** A step (s) during which the volumes, {@code d} apart at {@code t}, cannot touch. */
    private double safeStep(
            BodyCurve a, Volume va, BodyCurve b, Volume vb, double t, double until, double d) {
        double rest = until - t;
        double h = d / motion.closing();
        double g = along(va, poseA, vb, poseB);
        if (g > 0 && h < rest) {
            double closing = motion.closing(gap.nx, gap.ny, gap.nz);
            h = closing > 0 ? Math.max(h, g / closing) : rest;
        }
        if (h >= rest) {
            return rest;
        }
        return g > d / 2 ? Math.max(h, bentStep(a, va, b, vb, t, rest, g)) : h;
    }

    /** The longest step that the third bound allows, about; found by regula falsi (Illinois). */
    private double bentStep(
            BodyCurve a, Volume va, BodyCurve b, Volume vb, double t, double rest, double g) {
        double bend = motion.bend(gap.nx, gap.ny, gap.nz);
        double high = bend * rest * rest > 8 * g ? Math.sqrt(8 * g / bend) : rest;
        double above = g;
        double below = spare(a, va, b, vb, t, high, bend);
        if (below >= 0) {
            return high;
        }
        double low = 0;
        boolean lastAbove = false;
        boolean lastBelow = false;
        for (int trial = 0; trial < TRIALS; trial++) {
            double h = low + (high - low) * (above / (above - below));
            double spare = spare(a, va, b, vb, t, h, bend);
            if (spare >= 0) {
                low = h;
                if (spare < 0.01 * g) {
                    break;
                }
                above = spare;
                below *= lastAbove ? 0.5 : 1;
            } else {
                high = h;
                below = spare;
                above *= lastBelow ? 0.5 : 1;
            }
            lastAbove = spare >= 0;
            lastBelow = !lastAbove;
        }
        return low;
    }

    /** What the gap along n has, a step later, beyond the sag of the path up to there (m). */
    private double spare(
            BodyCurve a, Volume va, BodyCurve b, Volume vb, double t, double h, double bend) {
        a.poseAt(t + h, trialA);
        b.poseAt(t + h, trialB);
        return along(va, trialA, vb, trialB) - bend * h * h / 8;
    }

    /** The gap (m) between the planes across n that touch the volumes from either side. */
    private double along(Volume va, Pose a, Volume vb, Pose b) {
        double between =
                gap.nx * (a.x - b.x) + gap.ny * (a.y - b.y) + gap.nz * (a.z - b.z);
        return between
                - va.reach(a, -gap.nx, -gap.ny, -gap.nz)
                - vb.reach(b, gap.nx, gap.ny, gap.nz);
    }
}
