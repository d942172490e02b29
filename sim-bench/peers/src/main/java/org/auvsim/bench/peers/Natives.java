package org.auvsim.bench.peers;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Native libraries that come as resources in jars. */
final class Natives {
    private Natives() {}

    /**
     * Unpacks one and loads it.
     *
     * @throws IllegalStateException if no jar has it
     */
    @SuppressWarnings("restricted")
    static void load(String resource) {
        try (InputStream in = Natives.class.getClassLoader().getResourceAsStream(resource)) {
            if (in == null) {
                throw new IllegalStateException(
                        "no jar on the class path has "
                                + resource
                                + "; the peers need Linux on"
                                + " x86-64");
            }
            Path file = Files.createTempFile("peer", ".so");
            file.toFile().deleteOnExit();
            Files.write(file, in.readAllBytes());
            System.load(file.toString());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
