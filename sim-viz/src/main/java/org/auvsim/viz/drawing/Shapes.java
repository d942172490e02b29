package org.auvsim.viz.drawing;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.Capsule;
import org.auvsim.core.volume.Compound;
import org.auvsim.core.volume.HalfSpace;
import org.auvsim.core.volume.HeightMap;
import org.auvsim.core.volume.Part;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;

/** Paints volumes. */
final class Shapes {
    /** How large something is painted whose volume is not known (m). */
    private static final double UNKNOWN = 0.25;

    /** What goes on for ever is painted so many pictures' heights wide. */
    private static final double EVER = 6;

    private final Placement part = new Placement();
    private final Placement end = new Placement();

    /** A volume in a pose. */
    void paint(long id, Volume volume, Placement at, int colour, Picture picture) {
        switch (volume) {
            case Compound compound -> {
                for (int i = 0; i < compound.part().size(); i++) {
                    Part each = compound.part().get(i);
                    part.within(at, each.position(), each.orientation());
                    convex(each.volume(), part, colour, picture.brush());
                }
            }
            case HalfSpace _ -> plate(at, colour, picture);
            case HeightMap map -> picture.brush().surface(id, map, at.pose, colour);
            default -> convex(volume, at, colour, picture.brush());
        }
    }

    private void convex(Volume volume, Placement at, int colour, Brush brush) {
        switch (volume) {
            case Sphere sphere -> brush.ball(at.pose, sphere.radius(), colour);
            case Box box ->
                    brush.box(at.pose, box.size().x(), box.size().y(), box.size().z(), colour);
            case Capsule capsule -> capsule(capsule, at, colour, brush);
            default -> brush.ball(at.pose, bounded(volume), colour);
        }
    }

    private static double bounded(Volume volume) {
        return volume.isBounded() ? volume.boundingRadius() : UNKNOWN;
    }

    private void capsule(Capsule capsule, Placement at, int colour, Brush brush) {
        brush.tube(at.pose, capsule.length(), capsule.radius(), colour);
        for (int side = -1; side <= 1; side += 2) {
            double half = side * capsule.length() / 2;
            end.at(
                    at.pose.x + at.world(0, half, 0, 0),
                    at.pose.y + at.world(1, half, 0, 0),
                    at.pose.z + at.world(2, half, 0, 0));
            brush.ball(end.pose, capsule.radius(), colour);
        }
    }

    /** The plane of a half-space, around what is looked at. */
    private void plate(Placement at, int colour, Picture picture) {
        double nx = at.world(0, 0, 0, 1);
        double ny = at.world(1, 0, 0, 1);
        double nz = at.world(2, 0, 0, 1);
        double tx = picture.camera().target(0);
        double ty = picture.camera().target(1);
        double tz = picture.camera().target(2);
        double above = (tx - at.pose.x) * nx + (ty - at.pose.y) * ny + (tz - at.pose.z) * nz;
        part.within(at, Vec3.ZERO, Quat.IDENTITY);
        part.pose.x = tx - above * nx;
        part.pose.y = ty - above * ny;
        part.pose.z = tz - above * nz;
        double wide = picture.share(EVER);
        picture.brush().box(part.pose, wide, wide, 0, colour);
    }

    /** Something of which only the place is known. */
    void unknown(Placement at, int colour, Brush brush) {
        brush.box(at.pose, UNKNOWN, UNKNOWN, UNKNOWN, colour);
    }
}
