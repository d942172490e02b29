package org.auvsim.auvsml.framing;

import java.util.Arrays;

/** Bytes that are being collected; small again after a large message. */
final class FrameBuffer {
    private static final int SMALL = 1024;

    private byte[] bytes = new byte[SMALL];
    private int size;

    int size() {
        return size;
    }

    void add(byte b) {
        if (size == bytes.length) {
            bytes = Arrays.copyOf(bytes, 2 * size);
        }
        bytes[size++] = b;
    }

    void add(byte[] from, int offset, int length) {
        while (size + length > bytes.length) {
            bytes = Arrays.copyOf(bytes, 2 * bytes.length);
        }
        System.arraycopy(from, offset, bytes, size, length);
        size += length;
    }

    void clear() {
        size = 0;
        if (bytes.length > SMALL) {
            bytes = new byte[SMALL];
        }
    }

    /** What was collected; the buffer is empty then. */
    byte[] take() {
        byte[] taken = Arrays.copyOf(bytes, size);
        clear();
        return taken;
    }
}
