package org.auvsim.auvsml.run;

/** How the cells of a column are written. */
public enum CellForm {
    /** As a decimal number. */
    NUMBER,
    /** As a time of day, two digits each for hours, minutes and seconds: 205259, 205259.25. */
    HHMMSS
}
