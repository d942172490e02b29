package org.auvsim.core.volume;

import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;

import java.util.Comparator;
import java.util.List;

/**
 * A box where it stands in the world.
 *
 * @param centre (m)
 * @param turn whose columns are the directions of the edges
 * @param half half of each edge (m)
 */
record OrientedBox(Vec3 centre, Mat3 turn, Vec3 half) {
    /** An order of boxes that differ, by place, then orientation, then size. */
    static final Comparator<OrientedBox> ORDER =
            Comparator.comparing(OrientedBox::centre, vectors())
                    .thenComparing(box -> box.axis(0), vectors())
                    .thenComparing(box -> box.axis(1), vectors())
                    .thenComparing(OrientedBox::half, vectors());

    private static Comparator<Vec3> vectors() {
        return Comparator.comparingDouble(Vec3::x)
                .thenComparingDouble(Vec3::y)
                .thenComparingDouble(Vec3::z);
    }

    static OrientedBox of(Box box, Pose pose) {
        return new OrientedBox(pose.position(), pose.orientation().toMatrix(), box.halfSize());
    }

    /** Direction of edge {@code i}, 0 to 2. */
    Vec3 axis(int i) {
        return switch (i) {
            case 0 -> new Vec3(turn.xx(), turn.yx(), turn.zx());
            case 1 -> new Vec3(turn.xy(), turn.yy(), turn.zy());
            default -> new Vec3(turn.xz(), turn.yz(), turn.zz());
        };
    }

    /** Half the length (m) of edge {@code i}, 0 to 2. */
    double half(int i) {
        return half.component(i);
    }

    /** How far (m) the box reaches from its centre along a unit vector. */
    double reach(Vec3 n) {
        return half.x() * Math.abs(axis(0).dot(n))
                + half.y() * Math.abs(axis(1).dot(n))
                + half.z() * Math.abs(axis(2).dot(n));
    }

    /** The corner that is farthest along {@code n}. */
    Vec3 corner(Vec3 n) {
        return edgeMiddle(0, n).plus(halfEdge(0, n));
    }

    /** The middle of that edge along axis {@code i} which is farthest along {@code n}. */
    Vec3 edgeMiddle(int i, Vec3 n) {
        return centre.plus(halfEdge((i + 1) % 3, n)).plus(halfEdge((i + 2) % 3, n));
    }

    /** The corners, in order round it, of the face that looks most along {@code n}. */
    List<Vec3> face(Vec3 n) {
        int i = mostParallel(n);
        Vec3 middle = centre.plus(halfEdge(i, n));
        Vec3 u = axis((i + 1) % 3).times(half((i + 1) % 3));
        Vec3 v = axis((i + 2) % 3).times(half((i + 2) % 3));
        return List.of(
                middle.plus(u).plus(v),
                middle.minus(u).plus(v),
                middle.minus(u).minus(v),
                middle.plus(u).minus(v));
    }

    private int mostParallel(Vec3 n) {
        double x = Math.abs(axis(0).dot(n));
        double y = Math.abs(axis(1).dot(n));
        double z = Math.abs(axis(2).dot(n));
        return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    }

    /** Half of edge {@code i}, pointing along {@code n} rather than against it. */
    private Vec3 halfEdge(int i, Vec3 n) {
        return axis(i).times(Math.copySign(half(i), axis(i).dot(n)));
    }
}
