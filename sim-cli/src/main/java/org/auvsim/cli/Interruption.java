package org.auvsim.cli;

import org.jline.utils.Signals;

import java.util.concurrent.CountDownLatch;

/**
 * Ctrl-C, or a request to end from elsewhere, for as long as this is open: the process ends only
 * when it is closed, so that what is under way can be brought to a good end. Ctrl-C once more ends
 * it at once. Either way its exit code is that of a process which was interrupted.
 */
final class Interruption implements AutoCloseable {
    /** What a shell is told of a process that Ctrl-C ended. */
    static final int EXIT_CODE = 130;

    private final CountDownLatch done = new CountDownLatch(1);
    private final Thread hook;
    private volatile boolean requested;

    /** Runs {@code end}, on a thread of its own, when the end is requested. */
    Interruption(Runnable end) {
        hook = new Thread(() -> finish(end), "interruption");
        Runtime.getRuntime().addShutdownHook(hook);
    }

    /** Whether the end has been requested. */
    boolean isRequested() {
        return requested;
    }

    private void finish(Runnable end) {
        Signals.register("INT", () -> Runtime.getRuntime().halt(EXIT_CODE));
        requested = true;
        end.run();
        try {
            done.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void close() {
        done.countDown();
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException _) {
            // It runs: the process is ending.
        }
    }
}
