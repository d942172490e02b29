package org.auvsim.auvsml.document;

import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.xml.Place;
import org.auvsim.auvsml.xml.PlacedElement;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/** What is left of a document without the elements that have faults. */
final class SoundPart {
    private SoundPart() {}

    /**
     * Takes the elements below a root away that have faults.
     *
     * @return false, and nothing is taken, if the root itself has one
     */
    static boolean keep(PlacedElement root, List<Fault> faults) {
        TreeMap<Place, PlacedElement> children = new TreeMap<>();
        for (int i = 0; i < root.getContentSize(); i++) {
            if (root.getContent(i) instanceof PlacedElement child) {
                children.put(child.place(), child);
            }
        }
        Set<PlacedElement> faulty = new HashSet<>();
        for (Fault fault : faults) {
            Map.Entry<Place, PlacedElement> child =
                    children.floorEntry(new Place(fault.line(), fault.column()));
            if (child == null) {
                return false;
            }
            faulty.add(child.getValue());
        }
        faulty.forEach(root::removeContent);
        return true;
    }
}
