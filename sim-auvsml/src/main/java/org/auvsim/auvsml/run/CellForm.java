package org.auvsim.auvsml.run;

/** How the cells of a column are written. */
public enum CellForm {
    /** As a decimal number. */
    NUMBER("NUMBER"),
    /** As a time of day, two digits each for hours, minutes and seconds: 205259, 205259.25. */
    HHMMSS("HHMMSS"),
    /**
     * As a date with a time, 2024-06-10T12:00:00.25Z, which counts in seconds since 1970; without a
     * time zone it is in UTC.
     */
    ISO_8601("ISO-8601");

    private final String text;

    CellForm(String text) {
        this.text = text;
    }

    /** As documents have it. */
    @Override
    public String toString() {
        return text;
    }
}
