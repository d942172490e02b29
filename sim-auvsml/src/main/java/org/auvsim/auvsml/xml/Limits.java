package org.auvsim.auvsml.xml;

/**
 * What a text may be before it is refused unread.
 *
 * @param bytes of the whole text
 * @param depth of nested elements, the root counted
 * @param attributes of one element
 */
public record Limits(int bytes, int depth, int attributes) {
    /** For one root element with its messages: 64 KiB. */
    public static final Limits MESSAGE = new Limits(64 << 10, 32, 64);

    /** For a scenario file: 1 MiB. */
    public static final Limits SCENARIO = new Limits(1 << 20, 32, 64);

    /** Limits that are all at least 1. */
    public Limits {
        if (bytes < 1 || depth < 1 || attributes < 1) {
            throw new IllegalArgumentException(
                    "limits must be 1 or more, but are %d bytes, depth %d, %d attributes"
                            .formatted(bytes, depth, attributes));
        }
    }
}
