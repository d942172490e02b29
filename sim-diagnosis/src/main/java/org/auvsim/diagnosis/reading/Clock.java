package org.auvsim.diagnosis.reading;

/**
 * The times of rows: their stamps, exactly. Only whole seconds with several rows each are read as a
 * constant rate, which begins anew where seconds are missing.
 */
final class Clock {
    /** Stamps that are further apart (s) leave seconds out. */
    private static final double NEXT = 1.5;

    private final boolean isEven;
    private final double interval;
    private boolean hasBegun;
    private double stamp;
    private double time;

    Clock(Survey survey) {
        isEven = survey.hasWholeSeconds();
        interval = survey.interval();
    }

    /** The next row is of another run. */
    void restart() {
        hasBegun = false;
    }

    /** The time (s) of the next row, whose stamp this is. */
    double next(double stamp) {
        if (!isEven) {
            return stamp;
        }
        if (hasBegun) {
            boolean goesOn = stamp - this.stamp < NEXT;
            time = goesOn ? time + interval : Math.max(stamp, time + interval);
        } else {
            time = stamp;
        }
        this.stamp = stamp;
        hasBegun = true;
        return time;
    }
}
