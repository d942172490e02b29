package org.auvsim.server.lanes;

import org.auvsim.core.step.Lanes;
import org.jspecify.annotations.Nullable;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.IntConsumer;

/**
 * Lanes on threads that live as long as these: part 0 runs on the calling thread, each other part
 * always on the same daemon thread. Between two runs a thread spins for a moment, as a step has
 * many runs in quick succession, and then sleeps.
 *
 * <p>One thread at a time runs parts here, the one that owns the world.
 */
public final class ThreadLanes implements Lanes, AutoCloseable {
    /** The greatest number of lanes that are given. */
    public static final int MOST = 256;

    private static final int SPINS = 10_000;

    private final Worker[] workers;
    private final AtomicInteger unfinished = new AtomicInteger();
    private IntConsumer work = _ -> {};
    private volatile int run;
    private volatile boolean closed;
    private volatile Thread caller = Thread.currentThread();

    /**
     * So many lanes.
     *
     * @throws IllegalArgumentException unless there are 1 to {@value #MOST}
     */
    public ThreadLanes(int count) {
        if (count < 1 || count > MOST) {
            throw new IllegalArgumentException(
                    "the number of lanes must be 1 to %d, but is %d".formatted(MOST, count));
        }
        workers = new Worker[count - 1];
        for (int k = 0; k < workers.length; k++) {
            workers[k] = new Worker(k + 1);
            workers[k].thread.setDaemon(true);
            workers[k].thread.start();
        }
    }

    @Override
    public int count() {
        return workers.length + 1;
    }

    /**
     * {@inheritDoc}
     *
     * @throws IllegalStateException if the lanes have been closed
     */
    @Override
    public void run(IntConsumer part) {
        if (closed) {
            throw new IllegalStateException("the lanes have been closed");
        }
        caller = Thread.currentThread();
        work = part;
        unfinished.set(workers.length);
        int next = run + 1;
        run = next; // publishes all of the above
        for (Worker worker : workers) {
            LockSupport.unpark(worker.thread);
        }
        Throwable first = attempt(part, 0);
        awaitOthers();
        for (Worker worker : workers) {
            first = first == null ? worker.thrown : first;
        }
        throwOn(first);
    }

    private void awaitOthers() {
        for (int spins = 0; unfinished.get() > 0; spins++) {
            if (spins < SPINS) {
                Thread.onSpinWait();
            } else {
                LockSupport.park(this);
            }
        }
    }

    private static @Nullable Throwable attempt(IntConsumer part, int lane) {
        try {
            part.accept(lane);
            return null;
        } catch (RuntimeException | Error e) {
            return e;
        }
    }

    private static void throwOn(@Nullable Throwable thrown) {
        switch (thrown) {
            case RuntimeException e -> throw e;
            case Error e -> throw e;
            case null, default -> {
                // no part has failed
            }
        }
    }

    /** Ends the threads once they are done with the parts under way. */
    @Override
    public void close() {
        closed = true;
        for (Worker worker : workers) {
            LockSupport.unpark(worker.thread);
        }
    }

    /** A thread with its part of each run. */
    private final class Worker implements Runnable {
        private final int lane;
        private final Thread thread;
        private @Nullable Throwable thrown;

        Worker(int lane) {
            this.lane = lane;
            this.thread = new Thread(this, "lane " + lane);
        }

        @Override
        public void run() {
            int seen = 0;
            while (awaitRunAfter(seen)) {
                seen++;
                thrown = attempt(work, lane);
                if (unfinished.decrementAndGet() == 0) {
                    LockSupport.unpark(caller);
                }
            }
        }

        /** False if the lanes have been closed instead. */
        private boolean awaitRunAfter(int seen) {
            for (int spins = 0; run == seen && !closed; spins++) {
                if (spins < SPINS) {
                    Thread.onSpinWait();
                } else {
                    LockSupport.park(ThreadLanes.this);
                }
            }
            return run != seen;
        }
    }
}
