package org.auvsim.auvsml.xml;

import org.jdom2.Element;
import org.jdom2.Namespace;

import javax.xml.stream.Location;

/** An element that knows where its start tag begins in the text that it was read from. */
public final class PlacedElement extends Element {
    private final transient Place place;
    private final transient int offset;

    /** The name is a parser's: it is not verified a second time. */
    PlacedElement(String name, Location start) {
        this.name = name;
        this.namespace = Namespace.NO_NAMESPACE;
        this.place = new Place(start.getLineNumber(), start.getColumnNumber());
        this.offset = start.getCharacterOffset();
    }

    /** Where the start tag begins. */
    public Place place() {
        return place;
    }

    /** The names from the root to here, as {@code auvsml/pause-simulator-command}. */
    public String path() {
        return path(this);
    }

    private static String path(Element element) {
        Element parent = element.getParentElement();
        return parent == null ? element.getName() : path(parent) + "/" + element.getName();
    }

    /** Where the start tag begins, in UTF-16 units from the start of the text. */
    int offset() {
        return offset;
    }
}
