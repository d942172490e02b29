package org.auvsim.auvsml.mapping;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A file of the repository that is generated from the code, and must be what the code says. */
public final class GeneratedFile {
    private static final String COMMAND =
            "mvn -q test -pl sim-auvsml,sim-cli -am -Dtest='GeneratedFilesTest,GeneratedSchemaTest'"
                    + " -Dauvsml.generate -Dsurefire.failIfNoSpecifiedTests=false";

    private GeneratedFile() {}

    /** Fails unless the file holds this; with {@code -Dauvsml.generate} it is written instead. */
    public static void check(Path file, String content) throws IOException {
        if (System.getProperty("auvsml.generate") != null) {
            Files.createDirectories(file.toAbsolutePath().getParent());
            Files.writeString(file, content);
        }
        assertThat(file).as("generate it with: %s", COMMAND).exists();
        assertThat(Files.readString(file))
                .as("%s is not what the code says; generate it with: %s", file, COMMAND)
                .isEqualTo(content);
    }
}
