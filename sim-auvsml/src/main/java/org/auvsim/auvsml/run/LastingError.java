package org.auvsim.auvsml.run;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;

/**
 * An error of measurements that the next row still has, beside noise that it has not: of a lens, a
 * drifting zero, rough seas that a model leaves out. Its correlation falls as exp(-t / time), as
 * that of Ornstein and Uhlenbeck's process (1930).
 *
 * @param deviation standard deviation, in the usual unit of its column
 * @param time in which it is forgotten
 * @param grows whether there is none of it where a run begins, as of a prediction that strays from
 *     what is known there; else all of it may be there in the first row
 */
public record LastingError(double deviation, @Unit("s") double time, @Default("0") boolean grows) {
    /**
     * A checked error.
     *
     * @throws IllegalArgumentException if a number is not above 0
     */
    public LastingError {
        Domain.above0("a lasting error", "deviation", deviation, "");
        Domain.above0("a lasting error", "time", time, "s");
    }

    /** One that is there from the first row on. */
    public LastingError(double deviation, double time) {
        this(deviation, time, false);
    }

    /** The same in another unit. */
    public LastingError times(double factor) {
        return new LastingError(deviation * Math.abs(factor), time, grows);
    }
}
