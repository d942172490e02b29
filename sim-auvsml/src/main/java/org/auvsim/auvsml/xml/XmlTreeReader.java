package org.auvsim.auvsml.xml;

import com.ctc.wstx.exc.WstxEOFException;
import com.ctc.wstx.exc.WstxLazyException;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.Fault;
import org.codehaus.stax2.XMLStreamReader2;
import org.jdom2.AttributeType;
import org.jdom2.IllegalDataException;
import org.jdom2.Namespace;
import org.jdom2.UncheckedJDOMFactory;

import java.util.Arrays;
import java.util.Optional;

import javax.xml.XMLConstants;
import javax.xml.stream.Location;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/**
 * Reads a text into a JDOM tree of {@link PlacedElement}s; safe with any bytes (see {@link
 * HardenedXml}). One reader may be used by many threads.
 */
public final class XmlTreeReader {
    private static final UncheckedJDOMFactory NODES = new UncheckedJDOMFactory();

    private final Limits limits;
    private final HardenedXml parser;

    /** A reader that refuses what goes beyond {@code limits}. */
    public XmlTreeReader(Limits limits) {
        this.limits = limits;
        this.parser = new HardenedXml(limits);
    }

    /**
     * The tree of a whole text.
     *
     * @throws AuvsmlException if it is not well-formed, too large, or uses what AUVSML forbids
     */
    public XmlTree read(byte[] xml) throws AuvsmlException {
        if (xml.length > limits.bytes()) {
            throw new AuvsmlException(XmlFaults.tooLarge(limits));
        }
        try {
            XMLStreamReader2 reader = parser.open(xml);
            try {
                XmlFaults.refuseOtherEncoding(reader);
                return new XmlTree(build(reader), xml);
            } finally {
                reader.close();
            }
        } catch (XMLStreamException e) {
            throw new AuvsmlException(XmlFaults.of(e));
        } catch (WstxLazyException | IllegalDataException e) {
            throw new AuvsmlException(
                    new Fault(ErrorCode.MALFORMED_XML, XmlFaults.sentence(e), "", 1, 1));
        }
    }

    /** The name of a text's root element, if the text is sound up to there. */
    public Optional<String> rootName(byte[] xml) {
        try {
            XMLStreamReader2 reader = parser.open(xml);
            try {
                while (reader.hasNext()) {
                    if (reader.next() == XMLStreamReader.START_ELEMENT) {
                        return Optional.of(name(reader));
                    }
                }
                return Optional.empty();
            } finally {
                reader.close();
            }
        } catch (XMLStreamException | WstxLazyException _) {
            return Optional.empty();
        }
    }

    /** Whether a text is sound as far as it goes, but ends before its root element does. */
    public boolean isUnfinished(byte[] xml) {
        int end = xml.length;
        while (end > 0 && xml[end - 1] < 0) {
            end--; // a character of several bytes may not be whole
        }
        try {
            XMLStreamReader2 reader = parser.open(Arrays.copyOf(xml, end));
            try {
                while (reader.hasNext()) {
                    reader.next();
                }
                return false;
            } finally {
                reader.close();
            }
        } catch (WstxEOFException _) {
            return true;
        } catch (XMLStreamException | WstxLazyException _) {
            return false;
        }
    }

    private static PlacedElement build(XMLStreamReader2 reader)
            throws XMLStreamException, AuvsmlException {
        PlacedElement root = null;
        PlacedElement open = null;
        while (reader.hasNext()) {
            switch (reader.next()) {
                case XMLStreamReader.START_ELEMENT -> {
                    PlacedElement element = element(reader);
                    if (open != null) {
                        NODES.addContent(open, element);
                    }
                    root = root == null ? element : root;
                    open = element;
                }
                case XMLStreamReader.END_ELEMENT ->
                        open = open == null ? null : (PlacedElement) open.getParentElement();
                case XMLStreamReader.CHARACTERS, XMLStreamReader.CDATA -> {
                    if (open != null && !reader.isWhiteSpace()) {
                        NODES.addContent(open, NODES.text(reader.getText()));
                    }
                }
                case XMLStreamReader.DTD, XMLStreamReader.ENTITY_REFERENCE ->
                        throw new AuvsmlException(XmlFaults.forbidden(reader.getLocation()));
                default -> {
                    // comments, processing instructions, white space around the root
                }
            }
        }
        if (root == null) {
            Location end = reader.getLocation();
            throw new AuvsmlException(XmlFaults.noRoot(end));
        }
        return root;
    }

    private static PlacedElement element(XMLStreamReader2 reader) {
        PlacedElement element = new PlacedElement(name(reader), reader.getLocation());
        int count = reader.getAttributeCount();
        for (int i = 0; i < count; i++) {
            if (!XMLConstants.W3C_XML_SCHEMA_INSTANCE_NS_URI.equals(
                    reader.getAttributeNamespace(i))) {
                NODES.setAttribute(
                        element,
                        NODES.attribute(
                                attributeName(reader, i),
                                reader.getAttributeValue(i),
                                AttributeType.CDATA,
                                Namespace.NO_NAMESPACE));
            }
        }
        return element;
    }

    /** AUVSML has no namespaces: a prefix makes the name one that nobody knows. */
    private static String name(XMLStreamReader2 reader) {
        String prefix = reader.getPrefix();
        return prefix == null || prefix.isEmpty()
                ? reader.getLocalName()
                : prefix + ":" + reader.getLocalName();
    }

    private static String attributeName(XMLStreamReader2 reader, int i) {
        String prefix = reader.getAttributePrefix(i);
        return prefix == null || prefix.isEmpty()
                ? reader.getAttributeLocalName(i)
                : prefix + ":" + reader.getAttributeLocalName(i);
    }
}
