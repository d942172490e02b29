package org.auvsim.auvsml.mapping;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.framing.AuvsmlReader;
import org.auvsim.auvsml.framing.Incoming;
import org.auvsim.auvsml.framing.RootDecoder;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.xml.Limits;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

class GeneratedFilesTest {
    /** Tests run in the module's folder. */
    private static final Path DOCS = Path.of("..", "docs");

    private static final Path EXAMPLES =
            Path.of("src", "test", "resources", "org", "auvsim", "auvsml", "message");

    private final MessageCatalogue catalogue =
            MessageCatalogue.load(GeneratedFilesTest.class.getClassLoader());

    @Test
    void theReferenceIsThatOfTheRecords() throws IOException {
        Map<Class<?>, Message> examples = new HashMap<>();
        read(EXAMPLES.resolve("examples.xml")).forEach(m -> examples.put(m.getClass(), m));
        for (Path listing : listings()) {
            read(listing).forEach(m -> examples.put(m.getClass(), m));
        }
        String reference = MessageReference.write(catalogue, examples);
        assertThat(reference).as("tags of comments are turned into Markdown").doesNotContain("{@");
        GeneratedFile.check(DOCS.resolve("auvsml.md"), reference);
    }

    /** The appendix' listings after those of the conversation, whose place they take. */
    private static List<Path> listings() throws IOException {
        try (Stream<Path> files = Files.list(EXAMPLES.resolve("listings"))) {
            return files.sorted().toList();
        }
    }

    private List<Message> read(Path file) throws IOException {
        try (InputStream in = Files.newInputStream(file)) {
            AuvsmlReader reader =
                    new AuvsmlReader(
                            in, RootDecoder.strict(catalogue, Limits.MESSAGE), Limits.MESSAGE);
            List<Message> messages = new ArrayList<>();
            Incoming incoming = reader.next();
            while (incoming instanceof Incoming.Request(Optional<String> _, var root)) {
                messages.addAll(root);
                incoming = reader.next();
            }
            assertThat(incoming).as(file.toString()).isEqualTo(new Incoming.End());
            return messages;
        }
    }
}
