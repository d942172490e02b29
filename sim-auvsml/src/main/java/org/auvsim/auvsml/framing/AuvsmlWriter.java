package org.auvsim.auvsml.framing;

import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.xml.XmlText;

import java.util.List;
import java.util.Optional;

/**
 * Writes messages as bytes, straight from their records: once, however many listeners the bytes
 * then go to. May be used by many threads.
 */
public final class AuvsmlWriter {
    private final MessageCatalogue catalogue;

    /** A writer of messages; they need not be in the catalogue. */
    public AuvsmlWriter(MessageCatalogue catalogue) {
        this.catalogue = catalogue;
    }

    /** A message in a root element of its own, one line. */
    public byte[] write(Message message) {
        return write(Optional.empty(), List.of(message));
    }

    /**
     * Messages in one root element, one line.
     *
     * @throws IllegalArgumentException if a number is not finite or a text has a character that XML
     *     cannot hold
     */
    public byte[] write(Optional<String> requestId, List<? extends Message> messages) {
        XmlText out = XmlText.compact();
        catalogue.encode(requestId, messages, out);
        return out.toBytes();
    }

    /** A message in a root element of its own, indented for people. */
    public String writeIndented(Message message) {
        XmlText out = XmlText.indented();
        catalogue.encode(Optional.empty(), List.of(message), out);
        return out.toString();
    }
}
