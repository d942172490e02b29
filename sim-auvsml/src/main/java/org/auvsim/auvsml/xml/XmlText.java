package org.auvsim.auvsml.xml;

import java.nio.charset.StandardCharsets;

/**
 * An XML text that is being written, on one line or indented; attributes belong to the element that
 * was opened last. Names are trusted, values are escaped.
 */
public final class XmlText {
    private final StringBuilder text = new StringBuilder(1024);
    private final boolean indented;
    private int depth;
    private boolean tagOpen;

    private XmlText(boolean indented) {
        this.indented = indented;
    }

    /** A text without white space between elements: for the wire. */
    public static XmlText compact() {
        return new XmlText(false);
    }

    /** A text with an element a line: for people. */
    public static XmlText indented() {
        return new XmlText(true);
    }

    /** Begins an element. */
    public void open(String element) {
        closeTag();
        breakLine();
        text.append('<').append(element);
        tagOpen = true;
        depth++;
    }

    /** Ends the element that was begun last and is not ended yet. */
    public void close(String element) {
        depth--;
        if (tagOpen) {
            text.append("/>");
            tagOpen = false;
        } else {
            breakLine();
            text.append("</").append(element).append('>');
        }
    }

    /** An attribute with any value. */
    public void attribute(String name, String value) {
        escape(value, attribute(name));
        endAttribute();
    }

    /** An element that holds nothing but a text. */
    public void element(String name, String content) {
        closeTag();
        breakLine();
        escape(content, text.append('<').append(name).append('>'));
        text.append("</").append(name).append('>');
    }

    /** Begins an attribute; its value, escaped, is to be appended to what is returned. */
    public StringBuilder attribute(String name) {
        return text.append(' ').append(name).append("=\"");
    }

    /** Ends an attribute that {@link #attribute(String)} began. */
    public void endAttribute() {
        text.append('"');
    }

    /** Appends a value, escaped. */
    public static void escape(String value, StringBuilder text) {
        for (int i = 0; i < value.length(); i++) {
            char c = value.charAt(i);
            switch (c) {
                case '&' -> text.append("&amp;");
                case '<' -> text.append("&lt;");
                case '>' -> text.append("&gt;");
                case '"' -> text.append("&quot;");
                case '\t', '\n', '\r' -> text.append("&#").append((int) c).append(';');
                default -> text.append(c);
            }
        }
    }

    /** The text so far. */
    @Override
    public String toString() {
        return text.toString();
    }

    /** The finished text in UTF-8, with a line break at its end. */
    public byte[] toBytes() {
        return text.append('\n').toString().getBytes(StandardCharsets.UTF_8);
    }

    private void closeTag() {
        if (tagOpen) {
            text.append('>');
            tagOpen = false;
        }
    }

    private void breakLine() {
        if (indented && !text.isEmpty()) {
            text.append('\n').repeat("  ", depth);
        }
    }
}
