package org.auvsim.auvsml.xml;

import java.nio.charset.StandardCharsets;

/** The elements of a text, each with its place. */
public final class XmlTree {
    private final PlacedElement root;
    private final byte[] text;

    XmlTree(PlacedElement root, byte[] text) {
        this.root = root;
        this.text = text;
    }

    /** The root element. */
    public PlacedElement root() {
        return root;
    }

    /** Where an attribute's name stands; searched for in the text, since only errors ask for it. */
    public Place placeOf(PlacedElement element, String attribute) {
        String source = new String(text, StandardCharsets.UTF_8);
        int line = element.place().line();
        int column = element.place().column();
        char quote = 0;
        for (int i = element.offset(); i < source.length(); i++) {
            char c = source.charAt(i);
            if (quote == 0 && startsName(source, i, attribute)) {
                return new Place(line, column);
            }
            if (quote == 0 && c == '>') {
                break;
            }
            quote = quoteAfter(quote, c);
            column = c == '\n' ? 1 : column + 1;
            line = c == '\n' ? line + 1 : line;
        }
        return element.place();
    }

    private static char quoteAfter(char quote, char c) {
        if (quote == 0) {
            return c == '"' || c == '\'' ? c : 0;
        }
        return c == quote ? 0 : quote;
    }

    private static boolean startsName(String source, int i, String name) {
        if (i == 0 || source.charAt(i - 1) > ' ' || !source.startsWith(name, i)) {
            return false;
        }
        int end = i + name.length();
        return end < source.length() && (source.charAt(end) <= ' ' || source.charAt(end) == '=');
    }
}
