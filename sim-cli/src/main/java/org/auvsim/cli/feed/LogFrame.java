package org.auvsim.cli.feed;

import org.auvsim.core.math.Vec3;

/** The axes in which a log states positions. */
public enum LogFrame {
    /** x east, y north, z up: the world's own axes. */
    ENU {
        @Override
        Vec3 toWorld(Vec3 p) {
            return p;
        }
    },
    /** x north, y east, z down, as ships and underwater vehicles use them. */
    NED {
        @Override
        Vec3 toWorld(Vec3 p) {
            return new Vec3(p.y(), p.x(), -p.z());
        }
    };

    /** A position in the world's axes. */
    abstract Vec3 toWorld(Vec3 p);
}
