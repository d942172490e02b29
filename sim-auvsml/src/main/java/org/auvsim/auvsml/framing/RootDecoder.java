package org.auvsim.auvsml.framing;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.xml.Limits;
import org.auvsim.auvsml.xml.XmlTree;
import org.auvsim.auvsml.xml.XmlTreeReader;

import java.util.List;
import java.util.Optional;

/** Turns what a {@link FrameReader} found into messages. May be used by many threads. */
public final class RootDecoder {
    private final MessageCatalogue catalogue;
    private final XmlTreeReader trees;
    private final boolean lenient;

    private RootDecoder(MessageCatalogue catalogue, Limits limits, boolean lenient) {
        this.catalogue = catalogue;
        this.trees = new XmlTreeReader(limits);
        this.lenient = lenient;
    }

    /** For what clients send: what is not known is an error. */
    public static RootDecoder strict(MessageCatalogue catalogue, Limits limits) {
        return new RootDecoder(catalogue, limits, false);
    }

    /**
     * For what a server sends, which may be newer than this side: what is not known is left out.
     */
    public static RootDecoder lenient(MessageCatalogue catalogue, Limits limits) {
        return new RootDecoder(catalogue, limits, true);
    }

    /** The messages of a frame, or its first fault. */
    public Incoming decode(Frame frame) {
        return switch (frame) {
            case Frame.Broken broken -> new Incoming.Rejected(Optional.empty(), broken.fault());
            case Frame.Root root -> decode(root);
        };
    }

    private Incoming decode(Frame.Root frame) {
        Optional<String> requestId = Optional.empty();
        try {
            XmlTree tree = trees.read(frame.bytes());
            requestId = MessageCatalogue.requestId(tree);
            List<Message> messages =
                    lenient ? catalogue.decodeLeniently(tree) : catalogue.decode(tree);
            return new Incoming.Request(requestId, messages);
        } catch (AuvsmlException e) {
            Fault fault = e.fault().shiftedTo(frame.line(), frame.column());
            return new Incoming.Rejected(requestId, fault);
        }
    }
}
