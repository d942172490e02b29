package org.auvsim.viz.source;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.xml.Limits;
import org.auvsim.auvsml.xml.XmlTree;
import org.auvsim.auvsml.xml.XmlTreeReader;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;

/**
 * One root element from a simulator, which may know more than this viewer.
 *
 * @param requestId that of the question which it answers
 * @param messages those that can be read; none if one cannot be without what is unknown
 * @param unknown names of elements that are left out
 */
record Letter(Optional<String> requestId, List<Message> messages, List<String> unknown) {
    private static final XmlTreeReader TREES = new XmlTreeReader(Limits.ANSWER);

    /**
     * Reads a text.
     *
     * @throws AuvsmlException if it is not AUVSML
     */
    static Letter read(String text, MessageCatalogue catalogue) throws AuvsmlException {
        XmlTree tree = TREES.read(text.getBytes(StandardCharsets.UTF_8));
        Optional<String> requestId = MessageCatalogue.requestId(tree);
        try {
            return new Letter(requestId, catalogue.decode(tree), List.of());
        } catch (AuvsmlException e) {
            List<String> unknown = unknown(e);
            return new Letter(requestId, known(tree, catalogue, unknown), unknown);
        }
    }

    private static List<Message> known(
            XmlTree tree, MessageCatalogue catalogue, List<String> unknown) throws AuvsmlException {
        try {
            return catalogue.decodeLeniently(tree);
        } catch (AuvsmlException e) {
            if (unknown.isEmpty()) {
                throw e;
            }
            return List.of();
        }
    }

    private static List<String> unknown(AuvsmlException of) {
        return of.faults().stream()
                .filter(
                        fault ->
                                fault.code() == ErrorCode.UNKNOWN_ELEMENT
                                        || fault.code() == ErrorCode.UNKNOWN_MESSAGE)
                .map(fault -> fault.path().substring(fault.path().lastIndexOf('/') + 1))
                .distinct()
                .toList();
    }

    /** Its unknown elements as people read them. */
    String unknownWords() {
        return "<" + String.join(">, <", unknown) + ">";
    }
}
