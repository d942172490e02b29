package org.auvsim.diagnosis.run;

import org.auvsim.auvsml.run.MeasuredAxes;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/**
 * From the axes of a measurement to those of the simulator, x east, y north and z up, of the body
 * forward, left and up. Each of these changes is its own inverse.
 */
public enum Axes {
    /** Those of the simulator. */
    ENU {
        @Override
        public Vec3 world(Vec3 v) {
            return v;
        }

        @Override
        public Vec3 body(Vec3 v) {
            return v;
        }

        @Override
        public Quat orientation(Quat q) {
            return q;
        }
    },
    /** North, east and down, of the body forward, right and down (Fossen 2021, section 2.1). */
    NED {
        @Override
        public Vec3 world(Vec3 v) {
            return new Vec3(v.y(), v.x(), -v.z());
        }

        @Override
        public Vec3 body(Vec3 v) {
            return new Vec3(v.x(), -v.y(), -v.z());
        }

        @Override
        public Quat orientation(Quat q) {
            return NORTH_EAST_DOWN.times(q).times(FORWARD_RIGHT_DOWN);
        }
    };

    /** Half a turn about the axis between x and y. */
    private static final Quat NORTH_EAST_DOWN = new Quat(0, Math.sqrt(0.5), Math.sqrt(0.5), 0);

    /** Half a turn about x. */
    private static final Quat FORWARD_RIGHT_DOWN = new Quat(0, 1, 0, 0);

    /** As a mapping states them. */
    public static Axes of(MeasuredAxes stated) {
        return stated == MeasuredAxes.NED ? NED : ENU;
    }

    /** A vector in the world's axes. */
    public abstract Vec3 world(Vec3 v);

    /** A vector in the body's axes. */
    public abstract Vec3 body(Vec3 v);

    /** An orientation, body to world. */
    public abstract Quat orientation(Quat q);

    /** Sizes along the world's axes, without their signs. */
    public Vec3 sizes(Vec3 v) {
        Vec3 turned = world(v);
        return new Vec3(Math.abs(turned.x()), Math.abs(turned.y()), Math.abs(turned.z()));
    }
}
