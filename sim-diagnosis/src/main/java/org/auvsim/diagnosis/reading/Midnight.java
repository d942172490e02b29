package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.run.CellForm;

/** Times of day past midnight, which begin at 0 again: they count on into the next day. */
final class Midnight {
    private static final double DAY = 86_400;

    private final boolean areTimesOfDay;
    private final double day;
    private double last = Double.NaN;
    private int days;

    /** For the stamps of a column. */
    Midnight(BoundColumn time) {
        areTimesOfDay = time.form() == CellForm.HHMMSS;
        day = DAY * time.scale();
    }

    /** The next stamp is of another run. */
    void restart() {
        last = Double.NaN;
        days = 0;
    }

    /** A stamp (s), with the days since the first. */
    double countedOn(double stamp) {
        if (isPassedAt(stamp)) {
            days++;
        }
        last = stamp;
        return stamp + days * day;
    }

    /** Whether midnight is between the last stamp and this: it is more than half a day back. */
    boolean isPassedAt(double stamp) {
        return areTimesOfDay && (last - stamp) / day > 0.5;
    }
}
