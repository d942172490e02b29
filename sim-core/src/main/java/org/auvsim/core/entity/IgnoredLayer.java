package org.auvsim.core.entity;

import java.util.List;

/**
 * A layer of collisions whose objects an object passes through; enough if one of two ignores the
 * other's.
 *
 * @param layer 0 to {@value #LAST}
 */
public record IgnoredLayer(int layer) {
    /** The last of the layers. */
    public static final int LAST = 31;

    /**
     * A checked layer.
     *
     * @throws IllegalArgumentException if there is no such layer
     */
    public IgnoredLayer {
        requireLayer(layer);
    }

    static void requireLayer(int layer) {
        if (layer < 0 || layer > LAST) {
            throw new IllegalArgumentException(
                    "a collision layer must be 0 to " + LAST + ", but is " + layer);
        }
    }

    /** The layers as bits: layer k is bit k. */
    static int mask(List<IgnoredLayer> layers) {
        int mask = 0;
        for (IgnoredLayer ignored : layers) {
            mask |= 1 << ignored.layer;
        }
        return mask;
    }
}
