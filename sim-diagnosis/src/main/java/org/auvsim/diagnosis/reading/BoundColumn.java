package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.run.CellForm;

/**
 * A column of a file and what its numbers become: times the scale, plus the offset.
 *
 * @param field its index in a row
 * @param name in the header
 * @param slot where its number goes, see {@link Slots}
 */
record BoundColumn(int field, String name, int slot, double scale, double offset, CellForm form) {
    /** What the number of a cell is in the unit of its place. */
    double converted(double number) {
        return scale * number + offset;
    }
}
