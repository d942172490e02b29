package org.auvsim.auvsml.xml;

import com.ctc.wstx.api.WstxInputProperties;
import com.ctc.wstx.stax.WstxInputFactory;

import org.codehaus.stax2.XMLInputFactory2;
import org.codehaus.stax2.XMLStreamReader2;

import java.io.ByteArrayInputStream;

import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamException;

/**
 * Woodstox, set so that no text can make it read anything but that text, and none can make it work
 * longer than its size allows: no DTD, no entities, no external access, UTF-8 alone.
 */
final class HardenedXml {
    private final XMLInputFactory2 factory;

    HardenedXml(Limits limits) {
        factory = new WstxInputFactory();
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        factory.setProperty(XMLInputFactory.IS_REPLACING_ENTITY_REFERENCES, true);
        factory.setProperty(XMLInputFactory.IS_NAMESPACE_AWARE, true);
        factory.setProperty(XMLInputFactory2.P_LAZY_PARSING, false);
        factory.setProperty(WstxInputProperties.P_MAX_ELEMENT_DEPTH, limits.depth());
        factory.setProperty(WstxInputProperties.P_MAX_ATTRIBUTES_PER_ELEMENT, limits.attributes());
        factory.setProperty(WstxInputProperties.P_MAX_ATTRIBUTE_SIZE, limits.valueLength());
        factory.setProperty(WstxInputProperties.P_MAX_TEXT_LENGTH, (long) limits.bytes());
        factory.setProperty(WstxInputProperties.P_MAX_CHARACTERS, (long) limits.bytes());
    }

    XMLStreamReader2 open(byte[] xml) throws XMLStreamException {
        return (XMLStreamReader2)
                factory.createXMLStreamReader(new ByteArrayInputStream(xml), "UTF-8");
    }
}
