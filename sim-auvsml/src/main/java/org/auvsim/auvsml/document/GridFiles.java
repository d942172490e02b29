package org.auvsim.auvsml.document;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.xml.Place;
import org.auvsim.auvsml.xml.PlacedElement;
import org.auvsim.auvsml.xml.XmlTree;
import org.auvsim.core.entity.Field;
import org.auvsim.core.field.GriddedCurrent;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Reads the files that currents of a scenario name, so that it needs them no more. */
final class GridFiles {
    private GridFiles() {}

    /**
     * The scenario with the numbers of these files.
     *
     * @param folder where they are
     * @param faults to which those of the files are added, at the places where they are named
     */
    static Scenario in(Scenario scenario, Path folder, XmlTree tree, List<Fault> faults) {
        List<Field<?>> fields = new ArrayList<>();
        for (Field<?> field : scenario.field()) {
            fields.add(
                    field instanceof GriddedCurrent current
                            ? read(current, folder, tree, faults)
                            : field);
        }
        return scenario.withFields(fields);
    }

    private static GriddedCurrent read(
            GriddedCurrent current, Path folder, XmlTree tree, List<Fault> faults) {
        if (current.file().isEmpty()) {
            return current;
        }
        try {
            return new GridFile(folder.resolve(current.file().get())).read(current);
        } catch (GridFileException e) {
            faults.add(fault(String.valueOf(e.getMessage()), current, tree));
            return current;
        }
    }

    private static Fault fault(String problem, GriddedCurrent current, XmlTree tree) {
        PlacedElement element = tree.root();
        for (int i = 0; i < tree.root().getContentSize(); i++) {
            if (tree.root().getContent(i) instanceof PlacedElement field
                    && current.name().equals(field.getAttributeValue("name"))) {
                element = field;
            }
        }
        Place place = tree.placeOf(element, "file");
        return new Fault(
                ErrorCode.INVALID_VALUE,
                problem,
                element.path() + "@file",
                place.line(),
                place.column());
    }
}
