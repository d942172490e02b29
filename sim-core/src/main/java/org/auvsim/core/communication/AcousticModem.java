package org.auvsim.core.communication;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Vec3;

/**
 * A modem that talks through water by sound, at one speed and in straight lines.
 *
 * @param position in the body
 * @param channel only modems of one channel hear each other
 * @param range how far its messages reach
 * @param speed of sound
 * @param loss share of the messages that come to it and that it does not understand, 0 to 1
 * @param seed decides which
 */
public record AcousticModem(
        String name,
        @Unit("m") @Default("0 0 0") Vec3 position,
        @Default("1") String channel,
        @Unit("m") double range,
        @Unit("m/s") @Default("1500.0") double speed,
        @Default("0.0") double loss,
        @Default("0") long seed)
        implements Transceiver {
    /**
     * A checked modem.
     *
     * @throws IllegalArgumentException if range or speed is not positive, the loss outside [0, 1],
     *     or a number not finite
     */
    public AcousticModem {
        String of = Domain.named("acoustic-modem", name);
        Domain.finite(of, "position", position, "m");
        Domain.above0(of, "range", range, "m");
        Domain.above0(of, "speed", speed, "m/s");
        Domain.within(of, "loss", 0, 1, loss, "");
    }
}
