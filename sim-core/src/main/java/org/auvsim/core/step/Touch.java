package org.auvsim.core.step;

import org.auvsim.core.entity.BodyState;
import org.auvsim.core.volume.Manifold;
import org.auvsim.core.volume.PairQueries;
import org.auvsim.core.volume.Pose;

/** Finds the points where two bodies touch in their present states. */
final class Touch {
    private final BodyState bodies;
    private final BodyTraits traits;
    private final PairQueries queries;
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();

    Touch(BodyState bodies, BodyTraits traits, PairQueries queries) {
        this.bodies = bodies;
        this.traits = traits;
        this.queries = queries;
    }

    /** The points of two bodies where their surfaces are no farther apart than a margin (m). */
    void find(int a, int b, double margin, Manifold to) {
        if (traits.isSphere[a] && traits.isSphere[b]) {
            findSpheres(a, b, margin, to);
            return;
        }
        bodies.pose(a, poseA);
        bodies.pose(b, poseB);
        queries.manifold(traits.volume[a], poseA, traits.volume[b], poseB, margin, to);
    }

    /** The same where the bodies are in these poses. */
    void find(int a, Pose ofA, int b, Pose ofB, double margin, Manifold to) {
        if (traits.isSphere[a] && traits.isSphere[b]) {
            findSpheres(a, ofA.x, ofA.y, ofA.z, b, ofB.x, ofB.y, ofB.z, margin, to);
            return;
        }
        queries.manifold(traits.volume[a], ofA, traits.volume[b], ofB, margin, to);
    }

    private void findSpheres(int a, int b, double margin, Manifold to) {
        double[] x = bodies.column(BodyState.X);
        double[] y = bodies.column(BodyState.Y);
        double[] z = bodies.column(BodyState.Z);
        findSpheres(a, x[a], y[a], z[a], b, x[b], y[b], z[b], margin, to);
    }

    private void findSpheres(
            int a,
            double ax,
            double ay,
            double az,
            int b,
            double bx,
            double by,
            double bz,
            double margin,
            Manifold to) {
        double nx = ax - bx;
        double ny = ay - by;
        double nz = az - bz;
        double distance = Math.sqrt(nx * nx + ny * ny + nz * nz);
        double gap = distance - traits.radius[a] - traits.radius[b];
        to.clear();
        if (gap > margin) {
            return;
        }
        if (distance > 0) {
            nx /= distance;
            ny /= distance;
            nz /= distance;
        } else {
            // Concentric balls have no direction to part in; upward is the same on every machine.
            nz = 1;
        }
        double out = traits.radius[b] + gap / 2;
        to.add(bx + nx * out, by + ny * out, bz + nz * out, nx, ny, nz, gap);
    }
}
