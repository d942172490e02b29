package org.auvsim.cli;

import org.jline.utils.Signals;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;

/**
 * Ctrl-C, or a request to end from elsewhere, for as long as this is open: the process ends only
 * when it is closed, so that what is under way can be brought to a good end. Ctrl-C once more ends
 * it at once. Either way its exit code is that of a process which was interrupted.
 */
final class Interruption implements AutoCloseable {
    /** What a shell is told of a process that Ctrl-C ended. */
    static final int EXIT_CODE = 130;

    private static final Duration FOR_EVER = Duration.ofNanos(Long.MAX_VALUE);

    private final CountDownLatch inSight = new CountDownLatch(1);
    private final CountDownLatch done = new CountDownLatch(1);

    /** Whoever takes it first decides: the end is in sight, or what is under way is given up. */
    private final Semaphore fate = new Semaphore(1);

    private final Thread hook;
    private volatile boolean requested;

    /** Runs {@code end}, on a thread of its own, when the end is requested. */
    Interruption(Runnable end) {
        this(end, FOR_EVER, () -> {});
    }

    /**
     * The same for what may take too long: unless {@link #endIsInSight} is called so soon after the
     * request, what is under way is given up, {@code givingUp} runs, and the process ends.
     */
    Interruption(Runnable end, Duration patience, Runnable givingUp) {
        hook = new Thread(() -> finish(end, patience, givingUp), "interruption");
        Runtime.getRuntime().addShutdownHook(hook);
    }

    /** Whether the end has been requested. */
    boolean isRequested() {
        return requested;
    }

    /** From here on nothing is given up any more. Does not return if it already was. */
    void endIsInSight() {
        fate.acquireUninterruptibly();
        inSight.countDown();
    }

    private void finish(Runnable end, Duration patience, Runnable givingUp) {
        Signals.register("INT", () -> Runtime.getRuntime().halt(EXIT_CODE));
        requested = true;
        end.run();
        try {
            if (!inSight.await(patience.toNanos(), TimeUnit.NANOSECONDS) && fate.tryAcquire()) {
                givingUp.run();
            } else {
                done.await();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void close() {
        inSight.countDown();
        done.countDown();
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException _) {
            // It runs: the process is ending.
        }
    }
}
