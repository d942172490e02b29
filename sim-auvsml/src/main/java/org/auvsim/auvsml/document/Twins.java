package org.auvsim.auvsml.document;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.xml.Place;
import org.auvsim.auvsml.xml.PlacedElement;
import org.auvsim.auvsml.xml.XmlTree;
import org.jdom2.Attribute;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Entities of a scenario that bear an id or a name that another one bears. */
final class Twins {
    private Twins() {}

    /** A fault for each, at the second one's place. */
    static List<Fault> in(XmlTree tree) {
        List<Fault> faults = new ArrayList<>();
        for (String attribute : List.of("id", "name")) {
            Map<String, PlacedElement> first = new HashMap<>();
            for (int i = 0; i < tree.root().getContentSize(); i++) {
                if (tree.root().getContent(i) instanceof PlacedElement entity) {
                    compare(tree, entity, attribute, first, faults);
                }
            }
        }
        return faults;
    }

    private static void compare(
            XmlTree tree,
            PlacedElement entity,
            String name,
            Map<String, PlacedElement> first,
            List<Fault> faults) {
        Attribute attribute = entity.getAttribute(name);
        if (attribute == null) {
            return;
        }
        PlacedElement other = first.putIfAbsent(attribute.getValue().strip(), entity);
        if (other != null) {
            Place place = tree.placeOf(entity, name);
            faults.add(
                    new Fault(
                            ErrorCode.INVALID_VALUE,
                            "the %s '%s' is that of the <%s> in line %d; expected another one"
                                    .formatted(
                                            name,
                                            attribute.getValue(),
                                            other.getName(),
                                            other.place().line()),
                            tree.root().getName() + "/" + entity.getName() + "@" + name,
                            place.line(),
                            place.column()));
        }
    }
}
