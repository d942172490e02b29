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
 *   <li>Let n be the direction of the gap and g the gap between the planes across n that the
 *       volumes touch from either side. While g &gt; 0 they are apart, whatever else they do, and g
 *       falls no faster than points near each other along n: g / closing along n.
 *   <li>g is the least of all distances along n between a point of one and a point of the other. If
 *       each of these has a second derivative of at most m and is g0 or more at one instant and g1
 *       or more another h later, then it is at least min(g0, g1) - m h^2 / 8 all the time between.
 *       So min(g0, g1) &gt;= m h^2 / 8 proves that they stay apart.
 * </ol>
 *
 * <p>Where bodies turn, n turns, and the third bound for a fixed n takes a constant share of the
 * gap with each step. So once the gap's slope is known a leap to where it should end is tried, and
 * proved by a direction that goes over from n0 to n1 as m = (1 - s) n0 + s n1: along m distances
 * have second derivatives of at most m + 2 |n1 - n0| / h times the closing speed. Near a contact a
 * leap leaves of the gap the order of its square.
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

    // Gap and poses at the time that has been reached, and at a later one that is tried.
    private Separation gap = new Separation();
    private Pose poseA = new Pose();
    private Pose poseB = new Pose();
    private Separation gapAhead = new Separation();
    private Pose aheadA = new Pose();
    private Pose aheadB = new Pose();

    ConservativeAdvancement(PairQueries queries) {
        this.queries = queries;
    }

    /**
     * First time from {@code t0} to {@code t1} (s), both on both curves, at which the volumes
     * touch: the gap is then above 0 and no more than {@value #CONTACT} of the smaller bounding
     * radius; infinity if they do not.
     *
     * <p>Volumes that touch or overlap at {@code t0} are in contact there if they get nearer; if
     * they part, the first contact after that counts. After {@value #STEPS} steps the time that has
     * been reached is given as a contact, since up to there and no farther the volumes are known to
     * be apart: too early is safe, as a response to a contact without approach changes nothing.
     *
     * <p>A volume without bounds (half-space, height map) must not turn.
     */
    double first(BodyCurve a, Volume va, BodyCurve b, Volume vb, double t0, double t1) {
        double t = parted(a, va, b, vb, t0, t1);
        double touch = touch(va, vb);
        double slope = 0;
        double swing = 0;
        double until = t;
        for (int step = 0; step < STEPS && t < t1 && gap.distance > touch; step++) {
            if (t >= until || step % STEPS_FOR_ONE_BOUND == 0) {
                until = motion.look(a, va, b, vb, t, t1);
            }
            double h = boldStep(slope, swing, touch);
            if (!(t + h < until && leap(a, va, b, vb, t, h))) {
                h = safeStep(a, va, b, vb, t, until);
                double next = h < until - t ? t + h : until;
                if (next >= t1) {
                    return Double.POSITIVE_INFINITY;
                }
                h = next - t;
                lookAhead(a, va, b, vb, next);
            }
            if (!(t + h > t)) {
                return t;
            }
            slope = (gap.distance - gapAhead.distance) / h;
            swing = turnAhead() / h;
            t = t + h;
            goAhead();
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
        lookAhead(a, va, b, vb, t);
        goAhead();
        double touch = touch(va, vb);
        double least = gap.distance - FALL * touch;
        // What overlaps deeper than contacts do was put there; it has no gap to keep.
        double sag = gap.distance < -SAG * touch ? Double.POSITIVE_INFINITY : SAG * touch;
        double until = t0;
        for (int step = 0; step < STEPS && t < t1 && gap.distance <= 2 * touch; step++) {
            if (t >= until) {
                until = motion.look(a, va, b, vb, t, t1);
            }
            double next = until;
            double shortest = SAG * touch / motion.closing();
            lookAhead(a, va, b, vb, next);
            while (next - t > shortest && (gapAhead.distance < least || sag(next - t) > sag)) {
                next = t + (next - t) / 4;
                lookAhead(a, va, b, vb, next);
            }
            if (gapAhead.distance < least || !(next > t)) {
                return t;
            }
            t = next;
            goAhead();
        }
        return t;
    }

    /** The gap (m) at which these volumes, where they now are, are in contact. */
    private double touch(Volume va, Volume vb) {
        double size = Math.min(va.boundingRadius(), vb.boundingRadius());
        double far = Math.max(Math.abs(poseA.x), Math.max(Math.abs(poseA.y), Math.abs(poseA.z)));
        return Math.max(CONTACT * size, ROUNDING * far);
    }

    private void lookAhead(BodyCurve a, Volume va, BodyCurve b, Volume vb, double t) {
        a.poseAt(t, aheadA);
        b.poseAt(t, aheadB);
        queries.distance(va, aheadA, vb, aheadB, gapAhead);
    }

    private void goAhead() {
        Separation gapBehind = gap;
        gap = gapAhead;
        gapAhead = gapBehind;
        Pose behindA = poseA;
        poseA = aheadA;
        aheadA = behindA;
        Pose behindB = poseB;
        poseB = aheadB;
        aheadB = behindB;
    }

    /**
     * A step (s) that should end where little of the gap is left, if its slope stays; 0 if none.
     */
    private double boldStep(double slope, double swing, double touch) {
        if (!(slope > 0)) {
            return 0;
        }
        double closing = motion.closing();
        double sagging = motion.bend(gap.nx, gap.ny, gap.nz) / 8 + swing * closing / 4;
        double whole = gap.distance / slope;
        double h = whole - (2 * sagging * whole * whole + touch / 2) / slope;
        return h > gap.distance / closing ? h : 0;
    }

    /** Looks ahead; whether it is proved that the volumes stay apart up to there. */
    private boolean leap(BodyCurve a, Volume va, BodyCurve b, Volume vb, double t, double h) {
        if (!(h > 0)) {
            return false;
        }
        lookAhead(a, va, b, vb, t + h);
        double g0 = along(gap, va, poseA, vb, poseB);
        double g1 = along(gapAhead, va, aheadA, vb, aheadB);
        return g1 > 0 && Math.min(g0, g1) >= sag(h);
    }

    /** How much less (m) than at both ends the gap can be in between, {@code h} (s) apart. */
    private double sag(double h) {
        double here = motion.bend(gap.nx, gap.ny, gap.nz);
        double there = motion.bend(gapAhead.nx, gapAhead.ny, gapAhead.nz);
        return (Math.max(here, there) * h + 2 * turnAhead() * motion.closing()) * h / 8;
    }

    /** |n1 - n0|. */
    private double turnAhead() {
        double x = gapAhead.nx - gap.nx;
        double y = gapAhead.ny - gap.ny;
        double z = gapAhead.nz - gap.nz;
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** A step (s) from {@code t} during which the volumes cannot touch. */
    private double safeStep(
            BodyCurve a, Volume va, BodyCurve b, Volume vb, double t, double until) {
        double rest = until - t;
        double d = gap.distance;
        double h = d / motion.closing();
        double g = along(gap, va, poseA, vb, poseB);
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
        a.poseAt(t + h, aheadA);
        b.poseAt(t + h, aheadB);
        return along(gap, va, aheadA, vb, aheadB) - bend * h * h / 8;
    }

    /** The gap (m) between the planes across its direction that touch the volumes. */
    private static double along(Separation gap, Volume va, Pose a, Volume vb, Pose b) {
        double between = gap.nx * (a.x - b.x) + gap.ny * (a.y - b.y) + gap.nz * (a.z - b.z);
        return between
                - va.reach(a, -gap.nx, -gap.ny, -gap.nz)
                - vb.reach(b, gap.nx, gap.ny, gap.nz);
    }
}
