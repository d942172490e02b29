package org.auvsim.auvsml.document.recording;

import org.auvsim.auvsml.document.DocumentException;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Optional;

/** Cuts pieces of text into lines, each with its line feed but for the last. */
final class Lines {
    private final Blocks blocks;
    private byte[] block = {};
    private int from;

    Lines(Blocks blocks) {
        this.blocks = blocks;
    }

    /** The next line; empty at the end. */
    Optional<byte[]> next() throws IOException, DocumentException {
        ByteArrayOutputStream line = new ByteArrayOutputStream();
        while (fill()) {
            int end = from;
            while (end < block.length && block[end] != '\n') {
                end++;
            }
            boolean isWhole = end < block.length;
            end += isWhole ? 1 : 0;
            line.write(block, from, end - from);
            from = end;
            if (isWhole) {
                break;
            }
        }
        return line.size() == 0 ? Optional.empty() : Optional.of(line.toByteArray());
    }

    private boolean fill() throws IOException, DocumentException {
        if (from < block.length) {
            return true;
        }
        block = blocks.next().orElse(new byte[0]);
        from = 0;
        return block.length > 0;
    }
}
