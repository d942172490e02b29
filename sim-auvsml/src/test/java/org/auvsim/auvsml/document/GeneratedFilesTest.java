package org.auvsim.auvsml.document;

import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Path;

class GeneratedFilesTest {
    /** Tests run in the module's folder. */
    private static final Path DOCS = Path.of("..", "docs");

    private final MessageCatalogue catalogue =
            MessageCatalogue.load(GeneratedFilesTest.class.getClassLoader());

    @Test
    void theSchemaIsThatOfTheRecords() throws IOException {
        GeneratedFile.check(DOCS.resolve("auvsml.xsd"), Schema.of(catalogue));
    }
}
