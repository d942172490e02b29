package org.auvsim.core.step;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.volume.Pose;

/**
 * Where all bodies are on their segments: cubics in Bezier form, the boxes that these sweep with
 * the bodies' bounding radii, and the ends of the orientations. By slot; instants are offsets (s)
 * from the frame's beginning.
 */
final class Paths {
    /** Numbers of a curve: 12 of four control points (m), then the offsets of start and end. */
    static final int CURVE = 16;

    static final int START = 12;
    static final int END = 13;

    /** Numbers of a box: min x, y, z, max x, y, z (m). */
    static final int BOX = 6;

    private static final int SPIN = 6;

    private final BodyState bodies;
    private final BodyTraits traits;
    private final ContactForces forces;
    private final double[][] end;
    private final double[] curve;
    private final double[] box;

    /** Angular velocities (rad/s, world) at start and end, where orientations matter at all. */
    private final double[] spin;

    /** Where the box of a fixed body has been found: position, then orientation. */
    private final double[] placed;

    Paths(BodyState bodies, BodyTraits traits, ContactForces forces) {
        this.bodies = bodies;
        this.traits = traits;
        this.forces = forces;
        int count = bodies.count();
        end = new double[BodyState.COLUMNS][bodies.column(0).length];
        curve = new double[CURVE * count];
        box = new double[BOX * count];
        spin = new double[traits.areAllSpheres ? 0 : SPIN * count];
        placed = new double[BodyState.PX * count];
    }

    double[] curves() {
        return curve;
    }

    double[] boxes() {
        return box;
    }

    /** The bodies' states at the ends of their segments, by column. */
    double[][] ends() {
        return end;
    }

    double startOf(int body) {
        return curve[CURVE * body + START];
    }

    double endOf(int body) {
        return curve[CURVE * body + END];
    }

    /** A segment has been cut at an offset, from which the next one will begin. */
    void beginAt(int body, double offset) {
        curve[CURVE * body + START] = offset;
    }

    /** Whether orientations are followed along the segments. */
    boolean turn() {
        return spin.length > 0;
    }

    /** Notes the angular velocities of a block at its bodies' starts (0) or ends (3). */
    void noteSpin(Block block, int at) {
        for (int i = 0; i < block.count; i++) {
            int to = SPIN * block.slot(i) + at;
            spin[to] = block.wx[i];
            spin[to + 1] = block.wy[i];
            spin[to + 2] = block.wz[i];
        }
    }

    /** Loads the curve of a body's segment. */
    void load(int slot, BodyCurve to) {
        int at = CURVE * slot;
        to.path(curve[at + START], curve[at + END], curve, at);
        double[] qw = bodies.column(BodyState.QW);
        double[] qx = bodies.column(BodyState.QX);
        double[] qy = bodies.column(BodyState.QY);
        double[] qz = bodies.column(BodyState.QZ);
        if (traits.isFixed[slot] || !turn()) {
            to.unturned(qw[slot], qx[slot], qy[slot], qz[slot]);
            return;
        }
        int w = SPIN * slot;
        to.turnFrom(qw[slot], qx[slot], qy[slot], qz[slot], spin[w], spin[w + 1], spin[w + 2]);
        to.turnTo(
                end[BodyState.QW][slot],
                end[BodyState.QX][slot],
                end[BodyState.QY][slot],
                end[BodyState.QZ][slot],
                spin[w + 3],
                spin[w + 4],
                spin[w + 5]);
    }

    /** Traces the segments of the bodies {@code first} to {@code last - 1} of a block. */
    void trace(SegmentTrace trace, Block block, int first, int last, double from, double to) {
        trace.writeCurves(block, first, last, curve);
        trace.writeBoxes(block, first, last, box);
        for (int i = first; i < last; i++) {
            trace(block.slot(i), from, to);
        }
    }

    /** Traces a segment's time. */
    void trace(int slot, double from, double to) {
        curve[CURVE * slot + START] = from;
        curve[CURVE * slot + END] = to;
    }

    /** Traces a body that stands still; its box is found anew only where it has been moved. */
    void standStill(int slot, Pose pose, double from, double to) {
        trace(slot, from, to);
        if (isPlaced(slot)) {
            return;
        }
        pose(slot, pose);
        for (int at = CURVE * slot; at < CURVE * slot + START; at += 3) {
            curve[at] = pose.x;
            curve[at + 1] = pose.y;
            curve[at + 2] = pose.z;
        }
        traits.volume[slot].bounds(pose, box, BOX * slot);
    }

    /** Whether a body is where it was last time; from now on it is. */
    private boolean isPlaced(int slot) {
        boolean same = true;
        for (int c = BodyState.X; c < BodyState.PX; c++) {
            int at = BodyState.PX * slot + c;
            same &= placed[at] == bodies.column(c)[slot];
            placed[at] = bodies.column(c)[slot];
        }
        return same;
    }

    /** Where a body is halfway through its segment; how a plain ball is turned does not matter. */
    void middle(int slot, BodyCurve curveOf, Pose to) {
        if (traits.isFixed[slot]) {
            pose(slot, to);
            return;
        }
        if (traits.isPlainBall(slot)) {
            int p = CURVE * slot;
            to.x = (curve[p] + 3 * (curve[p + 3] + curve[p + 6]) + curve[p + 9]) / 8;
            to.y = (curve[p + 1] + 3 * (curve[p + 4] + curve[p + 7]) + curve[p + 10]) / 8;
            to.z = (curve[p + 2] + 3 * (curve[p + 5] + curve[p + 8]) + curve[p + 11]) / 8;
            to.qw = bodies.column(BodyState.QW)[slot];
            to.qx = bodies.column(BodyState.QX)[slot];
            to.qy = bodies.column(BodyState.QY)[slot];
            to.qz = bodies.column(BodyState.QZ)[slot];
            return;
        }
        load(slot, curveOf);
        curveOf.poseAt(0.5 * (curveOf.from() + curveOf.to()), to);
    }

    /** Where a body is at the end of its segment. */
    void endPose(int slot, Pose to) {
        if (traits.isFixed[slot]) {
            pose(slot, to);
            return;
        }
        to.x = end[BodyState.X][slot];
        to.y = end[BodyState.Y][slot];
        to.z = end[BodyState.Z][slot];
        to.qw = end[BodyState.QW][slot];
        to.qx = end[BodyState.QX][slot];
        to.qy = end[BodyState.QY][slot];
        to.qz = end[BodyState.QZ][slot];
    }

    /** Where a body is in its present state. */
    void pose(int slot, Pose to) {
        bodies.pose(slot, to);
    }

    /** A coordinate of the curve at a share of its segment (de Casteljau). */
    private double at(int slot, int axis, double s) {
        int p = CURVE * slot + axis;
        double a = curve[p] + s * (curve[p + 3] - curve[p]);
        double b = curve[p + 3] + s * (curve[p + 6] - curve[p + 3]);
        double c = curve[p + 6] + s * (curve[p + 9] - curve[p + 6]);
        double d = a + s * (b - a);
        return d + s * (b + s * (c - b) - d);
    }

    /**
     * How strongly two bodies are pressed together (m/s^2) at an offset by what is no contact
     * force: their relative acceleration against a direction that leads from b to a. Turning is
     * left out.
     */
    double pressure(int a, int b, double offset, double nx, double ny, double nz) {
        return nx * (acceleration(b, 0, offset) - acceleration(a, 0, offset))
                + ny * (acceleration(b, 1, offset) - acceleration(a, 1, offset))
                + nz * (acceleration(b, 2, offset) - acceleration(a, 2, offset));
    }

    /** The same along the line between their origins at the offset. */
    double pressure(int a, int b, double offset) {
        double nx = at(a, 0, share(a, offset)) - at(b, 0, share(b, offset));
        double ny = at(a, 1, share(a, offset)) - at(b, 1, share(b, offset));
        double nz = at(a, 2, share(a, offset)) - at(b, 2, share(b, offset));
        double distance = Math.sqrt(nx * nx + ny * ny + nz * nz);
        return distance == 0 ? 0 : pressure(a, b, offset, nx, ny, nz) / distance;
    }

    private double share(int slot, double offset) {
        double start = curve[CURVE * slot + START];
        return (offset - start) / (curve[CURVE * slot + END] - start);
    }

    private double acceleration(int slot, int axis, double offset) {
        int p = CURVE * slot + axis;
        double start = curve[CURVE * slot + START];
        double h = curve[CURVE * slot + END] - start;
        double s = (offset - start) / h;
        double first = curve[p] - 2 * curve[p + 3] + curve[p + 6];
        double last = curve[p + 3] - 2 * curve[p + 6] + curve[p + 9];
        double pushed = forces.along(slot, axis) * bodies.inverseMass()[slot];
        return 6 * (first + s * (last - first)) / (h * h) - pushed;
    }

    /**
     * How fast two bodies approach along the line between their origins at the frame's beginning:
     * there (m/s), and with their velocities at the ends of their segments.
     */
    void approaches(int a, int b, double[] to) {
        int p = CURVE * a;
        int q = CURVE * b;
        double squared = 0;
        double start = 0;
        double finish = 0;
        for (int axis = 0; axis < 3; axis++, p++, q++) {
            double d = curve[p] - curve[q];
            squared += d * d;
            start -= d * (curve[p + 3] - curve[p] - curve[q + 3] + curve[q]);
            finish -= d * (curve[p + 9] - curve[p + 6] - curve[q + 9] + curve[q + 6]);
        }
        double k = 3 / ((endOf(a) - startOf(a)) * Math.sqrt(squared));
        to[0] = k * start;
        to[1] = k * finish;
    }

    /** No less than how far (m) two bodies move relative to each other over their segments. */
    double relativeWay(int a, int b) {
        double way = 0;
        for (int k = 0; k < 9; k += 3) {
            double squared = 0;
            for (int axis = k; axis < k + 3; axis++) {
                int p = CURVE * a + axis;
                int q = CURVE * b + axis;
                double d = curve[p + 3] - curve[p] - curve[q + 3] + curve[q];
                squared += d * d;
            }
            way += Math.sqrt(squared);
        }
        return way;
    }
}
