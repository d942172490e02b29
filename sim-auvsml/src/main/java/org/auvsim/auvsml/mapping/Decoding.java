package org.auvsim.auvsml.mapping;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.xml.Place;
import org.auvsim.auvsml.xml.PlacedElement;
import org.auvsim.auvsml.xml.XmlTree;

import java.util.ArrayList;
import java.util.List;

/** What goes with one text while it is decoded: its places, and the faults found so far. */
final class Decoding {
    private final XmlTree tree;
    private final boolean lenient;
    private final List<Fault> faults = new ArrayList<>();

    /** Lenient: what nobody knows is passed over. */
    Decoding(XmlTree tree, boolean lenient) {
        this.tree = tree;
        this.lenient = lenient;
    }

    boolean isLenient() {
        return lenient;
    }

    int faultCount() {
        return faults.size();
    }

    List<Fault> faults() {
        return faults;
    }

    void fault(ErrorCode code, String problem, PlacedElement element) {
        add(code, problem, element.path(), element.place());
    }

    void fault(ErrorCode code, String problem, PlacedElement element, String attribute) {
        add(code, problem, element.path() + "@" + attribute, tree.placeOf(element, attribute));
    }

    private void add(ErrorCode code, String problem, String path, Place place) {
        faults.add(new Fault(code, problem, path, place.line(), place.column()));
    }
}
