package org.auvsim.diagnosis.reading;

/**
 * The times of rows: their stamps, exactly; past midnight those of a day count on. Only whole
 * seconds with several rows each are read as a constant rate, which begins anew where seconds are
 * missing.
 */
final class Clock {
    /** Stamps that are further apart (s) leave seconds out. */
    private static final double NEXT = 1.5;

    private final boolean isEven;
    private final double interval;
    private final Midnight midnight;
    private boolean hasBegun;
    private double stamp;
    private double time;

    Clock(Survey survey) {
        isEven = survey.hasWholeSeconds();
        interval = survey.interval();
        midnight = new Midnight(survey.time());
    }

    /** The next row is of another run. */
    void restart() {
        hasBegun = false;
        midnight.restart();
    }

    /** The time (s) of the next row, in which this stamp stands. */
    double next(double written) {
        double stamp = midnight.countedOn(written);
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
