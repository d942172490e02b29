package org.auvsim.auvsml.document.recording;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.document.DocumentException;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Optional;

/**
 * Cuts a recording into its root elements: each begins with a line whose first character is {@code
 * <} and whose second is not {@code /}. A root may so take one line or, indented, many.
 */
final class RootTexts {
    private final Lines lines;
    private Optional<byte[]> ahead = Optional.empty();
    private boolean begun;
    private int line;
    private long number;

    RootTexts(Blocks blocks) {
        this.lines = new Lines(blocks);
    }

    /** The next root; empty at the end. */
    Optional<RootText> next() throws IOException, DocumentException {
        if (!begun) {
            advance();
            begun = true;
        }
        while (ahead.isPresent() && new String(ahead.get(), UTF_8).isBlank()) {
            advance();
        }
        if (ahead.isEmpty()) {
            return Optional.empty();
        }
        int beginLine = line;
        ByteArrayOutputStream root = new ByteArrayOutputStream();
        do {
            root.writeBytes(ahead.orElseThrow());
            advance();
        } while (ahead.isPresent() && !beginsRoot(ahead.get()));
        number++;
        return Optional.of(new RootText(root.toByteArray(), number, beginLine, ahead.isEmpty()));
    }

    private void advance() throws IOException, DocumentException {
        ahead = lines.next();
        line++;
    }

    private static boolean beginsRoot(byte[] line) {
        return line[0] == '<' && !(line.length > 1 && line[1] == '/');
    }
}
