package org.auvsim.auvsml.document.recording;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/**
 * A gzip member (RFC 1952) that is being filled. An extra field of its header states the length of
 * the deflated bytes, twice, so that a member which is cut off can be told from one that is
 * damaged.
 */
final class GzipMember {
    /**
     * Magic, method, flag for an extra field, no time, no hints; the field's length, name, size.
     */
    static final byte[] HEADER = {
        0x1f, (byte) 0x8b, 8, 4, 0, 0, 0, 0, 0, (byte) 255, 12, 0, 'A', 'V', 8, 0
    };

    /** The header with the length of the deflated bytes, and its complement. */
    static final int HEADER_LENGTH = HEADER.length + 8;

    /** Checksum and length of the bytes before they were deflated. */
    static final int TRAILER_LENGTH = 8;

    private static final int FLAGS = 3;

    /** Of a header with an extra field. */
    private static final int FEXTRA = 4;

    private final Deflater deflater = new Deflater(Deflater.BEST_SPEED, /* nowrap= */ true);
    private final ByteArrayOutputStream deflated = new ByteArrayOutputStream();
    private final DeflaterOutputStream body = new DeflaterOutputStream(deflated, deflater);
    private final CRC32 checksum = new CRC32();
    private int length;

    /** Whether a member that begins so is gzip's, but of another program than this. */
    static boolean isForeign(byte[] header) {
        int name = HEADER.length - 6; // where the extra field stands
        return header.length == HEADER_LENGTH
                && Arrays.equals(header, 0, FLAGS, HEADER, 0, FLAGS)
                && (header[FLAGS] & FEXTRA) == 0
                && !Arrays.equals(header, name, HEADER.length, HEADER, name, HEADER.length);
    }

    void add(byte[] bytes) {
        try {
            body.write(bytes);
        } catch (IOException e) {
            throw new UncheckedIOException("memory cannot be written", e);
        }
        checksum.update(bytes);
        length += bytes.length;
    }

    /** So many bytes have been added. */
    int length() {
        return length;
    }

    /** The whole member; nothing can be added any more. */
    byte[] finish() {
        try {
            body.finish();
        } catch (IOException e) {
            throw new UncheckedIOException("memory cannot be written", e);
        } finally {
            deflater.end();
        }
        return ByteBuffer.allocate(HEADER_LENGTH + deflated.size() + TRAILER_LENGTH)
                .order(ByteOrder.LITTLE_ENDIAN)
                .put(HEADER)
                .putInt(deflated.size())
                .putInt(~deflated.size())
                .put(deflated.toByteArray())
                .putInt((int) checksum.getValue())
                .putInt(length)
                .array();
    }
}
