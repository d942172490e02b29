package org.auvsim.auvsml.xml;

/**
 * What a text may be before it is refused unread.
 *
 * @param bytes of the whole text
 * @param depth of nested elements, the root counted
 * @param attributes of one element
 * @param valueLength of one attribute's value, in characters
 */
public record Limits(int bytes, int depth, int attributes, int valueLength) {
    private static final int USUAL_VALUE_LENGTH = 4096;

    /** For one root element with its messages: 64 KiB. */
    public static final Limits MESSAGE = new Limits(64 << 10, 32, 64);

    /** For one root element that a server sends, which may be longer than what it takes: 1 MiB. */
    public static final Limits ANSWER = new Limits(1 << 20, 32, 64);

    /** For a scenario file: 1 MiB. */
    public static final Limits SCENARIO = new Limits(1 << 20, 32, 64);

    /** For one root element of a recording, whose scenario holds what its files held: 64 MiB. */
    public static final Limits RECORDING = new Limits(64 << 20, 64, 64, 64 << 20);

    /** Limits that are all at least 1. */
    public Limits {
        if (bytes < 1 || depth < 1 || attributes < 1 || valueLength < 1) {
            throw new IllegalArgumentException(
                    "limits must be 1 or more, but are %d bytes, depth %d, %d attributes, values of %d"
                            .formatted(bytes, depth, attributes, valueLength));
        }
    }

    /** The same with values of the usual length. */
    public Limits(int bytes, int depth, int attributes) {
        this(bytes, depth, attributes, USUAL_VALUE_LENGTH);
    }
}
