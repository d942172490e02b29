package org.auvsim.auvsml.recording;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;

import java.util.HexFormat;

/**
 * The world's {@link org.auvsim.core.world.World#stateHash state hash} after a step.
 *
 * @param revision how often the past had been revised or left
 * @param step so many steps had been made
 * @param timestamp the world's time
 * @param hash 16 hexadecimal digits
 */
public record StateHash(
        @Default("0") int revision, long step, @Unit("s") double timestamp, String hash)
        implements Entry {
    /**
     * A checked hash.
     *
     * @throws IllegalArgumentException if it is not 16 hexadecimal digits
     */
    public StateHash {
        if (!hash.matches("[0-9a-f]{16}")) {
            throw new IllegalArgumentException(
                    "a hash has 16 digits of 0-9 and a-f, but this is '%s'".formatted(hash));
        }
    }

    /** The hash with this value. */
    public static StateHash of(int revision, long step, double timestamp, long hash) {
        return new StateHash(revision, step, timestamp, HexFormat.of().toHexDigits(hash));
    }
}
