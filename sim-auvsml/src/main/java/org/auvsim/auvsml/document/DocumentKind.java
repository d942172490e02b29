package org.auvsim.auvsml.document;

import org.auvsim.auvsml.xml.Limits;
import org.auvsim.auvsml.xml.XmlTreeReader;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;

/** What a file is, told by how it begins, whatever its name is. */
public enum DocumentKind {
    /** A text with the root element {@code <scenario>}. */
    SCENARIO,
    /** Compressed by gzip, or a text with the root element {@code <recording>}. */
    RECORDING,
    /** Neither. */
    OTHER;

    /** So much of a file tells. */
    public static final int BEGINNING = 1 << 16;

    private static final XmlTreeReader TREES = new XmlTreeReader(Limits.SCENARIO);

    /** Of a file that begins so. */
    public static DocumentKind of(byte[] beginning) {
        if (beginning.length > 1 && beginning[0] == 0x1f && beginning[1] == (byte) 0x8b) {
            return RECORDING;
        }
        return switch (TREES.rootName(beginning).orElse("")) {
            case "scenario" -> SCENARIO;
            case "recording" -> RECORDING;
            default -> OTHER;
        };
    }

    /** Of a file. */
    public static DocumentKind of(Path file) throws IOException {
        try (InputStream in = Files.newInputStream(file)) {
            return of(in.readNBytes(BEGINNING));
        }
    }
}
