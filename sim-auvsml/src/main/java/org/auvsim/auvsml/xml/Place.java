package org.auvsim.auvsml.xml;

import java.util.Comparator;

/** A line and a column (in UTF-16 units) of a text, both from 1; in the text's order. */
public record Place(int line, int column) implements Comparable<Place> {
    private static final Comparator<Place> ORDER =
            Comparator.comparingInt(Place::line).thenComparingInt(Place::column);

    @Override
    public int compareTo(Place other) {
        return ORDER.compare(this, other);
    }
}
