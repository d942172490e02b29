package org.auvsim.auvsml.mapping;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.xml.PlacedElement;
import org.auvsim.auvsml.xml.XmlText;
import org.auvsim.auvsml.xml.XmlTree;
import org.jdom2.Attribute;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * All messages that this side knows, and the root elements that they travel in. One catalogue may
 * be used by many threads.
 */
public final class MessageCatalogue {
    private static final String ROOT = "auvsml";

    /** How the thesis' appendix prints the root; read, never written. */
    private static final String OTHER_ROOT = "auvxml";

    static final String REQUEST_ID = "request-id";

    private final AuvsmlMapper mapper;
    private final Map<String, Class<?>> types;

    private MessageCatalogue(AuvsmlMapper mapper) {
        this.mapper = mapper;
        this.types = mapper.implementations(Message.class);
        types.values().forEach(mapper::codec);
    }

    /**
     * The messages that {@code loader}'s files {@code META-INF/services/}{@link Message} name.
     *
     * @throws IllegalArgumentException if two have one name, or one cannot be written in AUVSML
     */
    public static MessageCatalogue load(ClassLoader loader) {
        return of(AuvsmlMapper.load(loader));
    }

    /** The messages that a mapper knows: for those that are registered with its builder. */
    public static MessageCatalogue of(AuvsmlMapper mapper) {
        return new MessageCatalogue(mapper);
    }

    /** The mapper of the messages' records. */
    public AuvsmlMapper mapper() {
        return mapper;
    }

    /** The record types of all messages, in order of their names. */
    public Collection<Class<?>> types() {
        return List.copyOf(types.values());
    }

    /** The parts of a message of a type, in their order. */
    public List<Part> parts(Class<?> type) {
        return mapper.codec(type).slots().stream().map(Part::of).toList();
    }

    /** The names of the roots that are read; the first one is written. */
    public static List<String> roots() {
        return List.of(ROOT, OTHER_ROOT);
    }

    /** The request-id that a root element states, if any. */
    public static Optional<String> requestId(XmlTree tree) {
        return Optional.ofNullable(tree.root().getAttributeValue(REQUEST_ID));
    }

    /** The messages of a root element; what is not known is an error. */
    public List<Message> decode(XmlTree tree) throws AuvsmlException {
        return decode(new Decoding(tree, false), tree.root());
    }

    /** The messages of a root element; what is not known is passed over. */
    public List<Message> decodeLeniently(XmlTree tree) throws AuvsmlException {
        return decode(new Decoding(tree, true), tree.root());
    }

    private List<Message> decode(Decoding decoding, PlacedElement root) throws AuvsmlException {
        List<Message> messages = new ArrayList<>();
        checkRoot(root, decoding);
        for (int i = 0; i < root.getContentSize(); i++) {
            if (root.getContent(i) instanceof PlacedElement element) {
                decodeMessage(element, decoding, messages);
            } else if (!decoding.isLenient()) {
                decoding.fault(ErrorCode.INVALID_VALUE, "expected messages, but found text", root);
            }
        }
        if (decoding.faultCount() > 0) {
            throw new AuvsmlException(decoding.faults());
        }
        return messages;
    }

    private static void checkRoot(PlacedElement root, Decoding decoding) {
        if (!roots().contains(root.getName())) {
            decoding.fault(
                    ErrorCode.UNKNOWN_ROOT,
                    "expected the root element <%s>, but found <%s>"
                            .formatted(ROOT, root.getName()),
                    root);
        }
        for (Attribute attribute : root.getAttributes()) {
            if (!attribute.getName().equals(REQUEST_ID) && !decoding.isLenient()) {
                decoding.fault(
                        ErrorCode.UNKNOWN_ATTRIBUTE,
                        "<%s> has no attribute %s; %s"
                                .formatted(
                                        root.getName(),
                                        Names.quoted(attribute.getName()),
                                        Names.nearest(attribute.getName(), List.of(REQUEST_ID))),
                        root,
                        attribute.getName());
            }
        }
        if (root.getContentSize() == 0) {
            decoding.fault(
                    ErrorCode.MISSING_VALUE, "expected a message, but the root is empty", root);
        }
    }

    private void decodeMessage(PlacedElement element, Decoding decoding, List<Message> messages) {
        Class<?> type = types.get(element.getName());
        if (type != null) {
            Object message = mapper.codec(type).decode(element, decoding);
            if (message != null) {
                messages.add((Message) message);
            }
        } else if (!decoding.isLenient()) {
            decoding.fault(
                    ErrorCode.UNKNOWN_MESSAGE,
                    "unknown message %s; %s"
                            .formatted(
                                    Names.quoted(element.getName()),
                                    Names.nearest(element.getName(), types.keySet())),
                    element);
        }
    }

    /**
     * A root element with these messages.
     *
     * @throws IllegalArgumentException if a number is not finite or a text is not XML's
     */
    public void encode(Optional<String> requestId, List<? extends Message> messages, XmlText out) {
        out.open(ROOT);
        if (requestId.isPresent()) {
            out.attribute(REQUEST_ID, requestId.get());
        }
        for (Message message : messages) {
            mapper.encode(message, out);
        }
        out.close(ROOT);
    }
}
