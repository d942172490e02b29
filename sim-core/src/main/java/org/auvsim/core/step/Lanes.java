package org.auvsim.core.step;

import java.util.function.IntConsumer;

/**
 * Where the parts of a step's work run side by side. The core starts no threads: a world is given
 * lanes. Work is cut and put together in the same order whatever their number, so that it is equal
 * to the bit.
 */
public interface Lanes {
    /** All work on the thread that makes the step. */
    Lanes ONE =
            new Lanes() {
                @Override
                public int count() {
                    return 1;
                }

                @Override
                public void run(IntConsumer part) {
                    part.accept(0);
                }
            };

    /** Number of parts that run side by side, 1 or more. */
    int count();

    /**
     * Runs parts 0 to {@code count() - 1}, each once, and returns when all are done; what they
     * wrote is then visible here. What a part throws is thrown on.
     */
    void run(IntConsumer part);
}
