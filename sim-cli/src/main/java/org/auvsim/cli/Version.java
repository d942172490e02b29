package org.auvsim.cli;

import static java.nio.charset.StandardCharsets.UTF_8;
import static java.util.Objects.requireNonNull;

import picocli.CommandLine.IVersionProvider;

import java.io.IOException;

/** The version that the build wrote into the jar. */
final class Version implements IVersionProvider {
    @Override
    public String[] getVersion() throws IOException {
        try (var text = requireNonNull(Version.class.getResourceAsStream("version.txt"))) {
            return new String[] {"auvsim " + new String(text.readAllBytes(), UTF_8).strip()};
        }
    }
}
