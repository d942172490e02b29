package org.auvsim.core.volume;

/** A bounded volume and a half-space: the corners of the volume's parts decide. */
final class SolidHalfSpace<A extends Volume> implements SolidQuery<A, HalfSpace> {
    @Override
    public double distance(A a, Pose poseA, HalfSpace b, Pose poseB, Separation to) {
        normal(poseB, to);
        double least = Double.POSITIVE_INFINITY;
        Core core = to.first;
        for (int i = 0; i < Core.parts(a); i++) {
            core.place(a, i, poseA);
            double height = height(core.x, core.y, core.z, poseB, to);
            double gap = height - core.along(to.nx, to.ny, to.nz) - core.radius;
            if (gap < least) {
                least = gap;
                to.distance = gap;
                // Straight below the middle of the face, edge or corner that is nearest.
                foot(core, height, to);
            }
        }
        return least;
    }

    private static void foot(Core core, double height, Separation to) {
        double x = core.x;
        double y = core.y;
        double z = core.z;
        for (int i = 0; i < core.dimensions; i++) {
            double down = core.component(i, to.nx, to.ny, to.nz);
            double step = Math.abs(down) < 1e-9 ? 0 : -Math.copySign(core.half[i], down);
            x += step * core.axes[3 * i];
            y += step * core.axes[3 * i + 1];
            z += step * core.axes[3 * i + 2];
        }
        double lowest = height - core.along(to.nx, to.ny, to.nz);
        double back = lowest - to.distance / 2;
        to.px = x - back * to.nx;
        to.py = y - back * to.ny;
        to.pz = z - back * to.nz;
    }

    @Override
    public void manifold(A a, Pose poseA, HalfSpace b, Pose poseB, double margin, Manifold to) {
        to.clear();
        Separation up = to.nearest;
        normal(poseB, up);
        Core core = up.first;
        for (int i = 0; i < Core.parts(a); i++) {
            core.place(a, i, poseA);
            int corners = 1 << core.dimensions;
            for (int corner = 0; corner < corners; corner++) {
                core.corner(corner);
                double gap = height(core.cx, core.cy, core.cz, poseB, up) - core.radius;
                if (gap <= margin) {
                    double back = core.radius + gap / 2;
                    to.add(
                            core.cx - back * up.nx,
                            core.cy - back * up.ny,
                            core.cz - back * up.nz,
                            up.nx,
                            up.ny,
                            up.nz,
                            gap);
                }
            }
        }
    }

    /** The plane's normal: the z axis of the half-space. */
    private static void normal(Pose pose, Separation to) {
        to.normal(
                2 * (pose.qx * pose.qz + pose.qw * pose.qy),
                2 * (pose.qy * pose.qz - pose.qw * pose.qx),
                1 - 2 * (pose.qx * pose.qx + pose.qy * pose.qy));
    }

    private static double height(double x, double y, double z, Pose plane, Separation up) {
        return (x - plane.x) * up.nx + (y - plane.y) * up.ny + (z - plane.z) * up.nz;
    }
}
