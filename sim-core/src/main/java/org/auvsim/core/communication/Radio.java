package org.auvsim.core.communication;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Vec3;

/**
 * A radio that talks through air at the speed of light. Under water it is deaf and dumb.
 *
 * @param position of its antenna in the body
 * @param channel only radios of one channel hear each other
 * @param range how far its messages reach
 * @param surface height of the still water's surface
 * @param maximumDepth of the antenna at which it still works
 * @param loss share of the messages that come to it and that it does not understand, 0 to 1
 * @param seed decides which
 */
public record Radio(
        String name,
        @Unit("m") @Default("0 0 0") Vec3 position,
        @Default("1") String channel,
        @Unit("m") double range,
        @Unit("m") @Default("0.0") double surface,
        @Unit("m") @Default("0.0") double maximumDepth,
        @Default("0.0") double loss,
        @Default("0") long seed)
        implements Transceiver {
    private static final double SPEED_OF_LIGHT = 299_792_458;

    /**
     * A checked radio.
     *
     * @throws IllegalArgumentException if the range is not positive, the depth negative, the loss
     *     outside [0, 1], or a number not finite
     */
    public Radio {
        String of = Domain.named("radio", name);
        Domain.finite(of, "position", position, "m");
        Domain.above0(of, "range", range, "m");
        Domain.finite(of, "surface", surface, "m");
        Domain.atLeast0(of, "maximum-depth", maximumDepth, "m");
        Domain.within(of, "loss", 0, 1, loss, "");
    }

    @Override
    public double speed() {
        return SPEED_OF_LIGHT;
    }

    @Override
    public boolean worksAt(Vec3 place) {
        return surface - place.z() <= maximumDepth;
    }
}
