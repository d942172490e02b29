package org.auvsim.core.volume;

import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;

import java.util.List;

/**
 * All that lies in one of several convex parts. The mass is shared out among the parts by what each
 * fills: where parts overlap, it counts twice.
 */
public record Compound(List<Part> part) implements Volume {
    /**
     * The compound of these parts.
     *
     * @throws IllegalArgumentException if there is none
     */
    public Compound {
        part = List.copyOf(part);
        if (part.isEmpty()) {
            throw new IllegalArgumentException(
                    "a compound needs at least one part, but has none; add a <part>");
        }
    }

    @Override
    public double boundingRadius() {
        double farthest = 0;
        for (Part each : part) {
            farthest = Math.max(farthest, each.farthest());
        }
        return farthest;
    }

    @Override
    public Vec3 centreOfMass() {
        Vec3 weighted = Vec3.ZERO;
        double filled = 0;
        for (Part each : part) {
            weighted = weighted.plus(each.position().times(each.cubicMetres()));
            filled += each.cubicMetres();
        }
        return weighted.times(1 / filled);
    }

    @Override
    public Mat3 inertia(double mass) {
        double filled = part.stream().mapToDouble(Part::cubicMetres).sum();
        Vec3 centre = centreOfMass();
        Mat3 sum = Mat3.diagonal(0, 0, 0);
        for (Part each : part) {
            Mat3 own = each.inertia(mass * each.cubicMetres() / filled, centre);
            sum =
                    new Mat3(
                            sum.xx() + own.xx(),
                            sum.xy() + own.xy(),
                            sum.xz() + own.xz(),
                            sum.yx() + own.yx(),
                            sum.yy() + own.yy(),
                            sum.yz() + own.yz(),
                            sum.zx() + own.zx(),
                            sum.zy() + own.zy(),
                            sum.zz() + own.zz());
        }
        return sum;
    }

    @Override
    public boolean contains(Vec3 point) {
        return part.stream().anyMatch(each -> each.contains(point));
    }

    @Override
    public double reach(Pose pose, double nx, double ny, double nz) {
        double x = pose.alongX(nx, ny, nz);
        double y = pose.alongY(nx, ny, nz);
        double z = pose.alongZ(nx, ny, nz);
        double farthest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < part.size(); i++) {
            farthest = Math.max(farthest, part.get(i).reach(x, y, z));
        }
        return farthest;
    }

    @Override
    public double distance(Ray ray) {
        double nearest = Ray.MISS;
        for (Part each : part) {
            Ray seen = ray.seenFrom(each.position(), each.orientation());
            nearest = Math.min(nearest, each.volume().distance(seen));
        }
        return nearest;
    }
}
