package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.document.Schema;
import org.auvsim.auvsml.mapping.GeneratedFile;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Path;

/** The schema has what all modules bring along, as this one sees them all. */
class GeneratedSchemaTest {
    private static final Path FILE = Path.of("..", "docs", "auvsml.xsd");

    @Test
    void theSchemaIsThatOfTheRecordsOfAllModules() throws IOException {
        String schema =
                Schema.of(MessageCatalogue.load(GeneratedSchemaTest.class.getClassLoader()));

        assertThat(schema).contains("learning-feedback-handler", "genetic-feedback-handler");
        GeneratedFile.check(FILE, schema);
    }
}
