package org.auvsim.server.simulator;

import java.util.Optional;

/** Where a step that waits gets inputs from: the mailbox, or what was recorded. */
public interface InputSource {
    /**
     * The next input, after waiting at most so long (ns) for it; empty if none has come.
     *
     * @throws InterruptedException if the thread is to end
     */
    Optional<Input> next(long nanos) throws InterruptedException;

    /** Whether nothing will come any more, so that waiting is in vain. */
    boolean isClosed();
}
