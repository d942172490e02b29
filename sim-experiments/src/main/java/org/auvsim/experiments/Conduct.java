package org.auvsim.experiments;

import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * How an experiment is run.
 *
 * @param quick whether to run a small one, which shows that it works and little else
 * @param progress is told in a line what is done next
 * @param stop whether to end early
 */
public record Conduct(boolean quick, Consumer<String> progress, BooleanSupplier stop) {
    /** Tells what is done next. */
    public void tell(String line) {
        progress.accept(line);
    }

    /** Whether to end early. */
    public boolean isStopped() {
        return stop.getAsBoolean();
    }
}
