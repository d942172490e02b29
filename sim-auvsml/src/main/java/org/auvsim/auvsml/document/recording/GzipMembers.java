package org.auvsim.auvsml.document.recording;

import org.auvsim.auvsml.document.DocumentException;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.Optional;
import java.util.zip.CRC32;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/**
 * Reads {@link GzipMember}s. A member is verified as a whole before any of it is given out; one
 * that is cut off at the file's end is left out.
 */
final class GzipMembers implements Blocks {
    /** Longer ones are not written; it keeps a forged length from taking all memory. */
    private static final int MOST_BYTES = 256 << 20;

    private final InputStream in;
    private final String file;
    private long offset;
    private long member;

    GzipMembers(InputStream in, String file) {
        this.in = in;
        this.file = file;
    }

    @Override
    public boolean mayEndAnywhere() {
        return false;
    }

    @Override
    public Optional<byte[]> next() throws IOException, DocumentException {
        byte[] header = in.readNBytes(GzipMember.HEADER_LENGTH);
        member++;
        int known = Math.min(header.length, GzipMember.HEADER.length);
        if (!Arrays.equals(header, 0, known, GzipMember.HEADER, 0, known)) {
            if (isAllZero(header) && isAllZero(in)) {
                return Optional.empty(); // what a file system leaves that lost its power
            }
            if (member == 1 && GzipMember.isForeign(header)) {
                throw new DocumentException(
                        "%s: it was packed by gzip, not by auvsim; unpack it with gunzip and use the text"
                                .formatted(file));
            }
            throw damaged("it does not begin as those that a recording is made of");
        }
        if (header.length < GzipMember.HEADER_LENGTH) {
            return Optional.empty();
        }
        ByteBuffer lengths = ByteBuffer.wrap(header).order(ByteOrder.LITTLE_ENDIAN);
        int length = lengths.getInt(GzipMember.HEADER.length);
        if (length != ~lengths.getInt(GzipMember.HEADER.length + 4)
                || length < 0
                || length > MOST_BYTES) {
            throw damaged("its length was changed");
        }
        byte[] rest = in.readNBytes(length + GzipMember.TRAILER_LENGTH);
        if (rest.length < length + GzipMember.TRAILER_LENGTH) {
            return Optional.empty();
        }
        byte[] text = inflated(rest, length);
        offset += header.length + rest.length;
        return Optional.of(text);
    }

    private byte[] inflated(byte[] rest, int length) throws DocumentException {
        ByteBuffer trailer = ByteBuffer.wrap(rest).order(ByteOrder.LITTLE_ENDIAN);
        int checksum = trailer.getInt(length);
        int textLength = trailer.getInt(length + 4);
        if (textLength <= 0 || textLength > MOST_BYTES) {
            throw damaged("its length was changed");
        }
        byte[] text = new byte[textLength];
        Inflater inflater = new Inflater(/* nowrap= */ true);
        try {
            inflater.setInput(rest, 0, length);
            int filled = inflater.inflate(text);
            boolean isWhole = filled == textLength && inflater.inflate(new byte[1]) == 0;
            if (!isWhole || !inflater.finished() || inflater.getRemaining() > 0) {
                throw damaged("its length is not what it states");
            }
        } catch (DataFormatException e) {
            throw damaged(String.valueOf(e.getMessage()));
        } finally {
            inflater.end();
        }
        CRC32 found = new CRC32();
        found.update(text);
        if ((int) found.getValue() != checksum) {
            throw damaged("its checksum does not fit");
        }
        return text;
    }

    private DocumentException damaged(String how) {
        return new DocumentException(
                ("%s: the recording is damaged or was changed: its gzip member %d, from byte %d on,"
                                + " is not as it was written: %s")
                        .formatted(file, member, offset, how));
    }

    private static boolean isAllZero(InputStream in) throws IOException {
        byte[] buffer = new byte[8192];
        for (int n = in.read(buffer); n >= 0; n = in.read(buffer)) {
            if (!isAllZero(Arrays.copyOf(buffer, n))) {
                return false;
            }
        }
        return true;
    }

    private static boolean isAllZero(byte[] bytes) {
        for (byte b : bytes) {
            if (b != 0) {
                return false;
            }
        }
        return true;
    }
}
