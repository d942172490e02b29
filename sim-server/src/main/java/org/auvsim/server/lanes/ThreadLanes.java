package org.auvsim.server.lanes;

import org.auvsim.core.step.Lanes;
import org.jspecify.annotations.Nullable;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.IntConsumer;

/**
 * Lanes on threads that live as long as these: part 0 runs on the calling thread, each other part
 * on a daemon thread of its own, or on the calling thread too if that one has not begun when part 0
 * is done, as on a machine that is busy with other things.
 *
 * <p>Between two runs a thread waits awake for about a millisecond, as a step has several runs in
 * quick succession, at first for itself and then letting others have the processor; then it sleeps,
 * so that an idle simulator costs nothing.
 *
 * <p>One thread at a time runs parts here, the one that owns the world.
 */
public final class ThreadLanes implements Lanes, AutoCloseable {
    /** The greatest number of lanes that are given. */
    public static final int MOST = 256;

    private static final int SPINS = 2_000;
    private static final int YIELDS = 2_000;

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
            worker.wake();
        }
        Throwable first = attempt(part, 0);
        for (Worker worker : workers) {
            worker.work(next);
        }
        awaitOthers();
        for (Worker worker : workers) {
            first = first == null ? worker.thrown : first;
        }
        throwOn(first);
    }

    private void awaitOthers() {
        for (int round = 0; unfinished.get() > 0; round++) {
            if (!stayAwake(round)) {
                LockSupport.park(this);
            }
        }
    }

    /**
     * Lets a moment pass, unless there have been enough of them. Yielding is a courtesy to what
     * else runs: nothing here depends on its having an effect.
     */
    @SuppressWarnings("ThreadPriorityCheck")
    private static boolean stayAwake(int round) {
        if (round < SPINS) {
            Thread.onSpinWait();
        } else if (round < SPINS + YIELDS) {
            Thread.yield();
        }
        return round < SPINS + YIELDS;
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
            worker.wake();
        }
    }

    /** A thread with its part of each run. */
    private final class Worker implements Runnable {
        private final int lane;
        private final Thread thread;
        private @Nullable Throwable thrown;
        private volatile boolean asleep;

        /** The last run of which somebody has taken the part. */
        private final AtomicInteger taken = new AtomicInteger();

        Worker(int lane) {
            this.lane = lane;
            this.thread = new Thread(this, "lane " + lane);
        }

        @Override
        public void run() {
            int seen = 0;
            while (awaitRunAfter(seen)) {
                seen = run;
                if (work(seen) && unfinished.get() == 0) {
                    LockSupport.unpark(caller);
                }
            }
        }

        /** Does the part in a run, if nobody has taken it yet; whether it has. */
        boolean work(int of) {
            if (!taken.compareAndSet(of - 1, of)) {
                return false;
            }
            thrown = attempt(work, lane);
            unfinished.decrementAndGet();
            return true;
        }

        /** Has to follow what it is to wake for. */
        void wake() {
            if (asleep) {
                LockSupport.unpark(thread);
            }
        }

        /** False if the lanes have been closed instead. */
        private boolean awaitRunAfter(int seen) {
            for (int round = 0; run == seen && !closed; round++) {
                if (!stayAwake(round)) {
                    sleepUnlessRunAfter(seen);
                }
            }
            return run != seen;
        }

        /** Says so before it looks again: whoever starts a run sees it then. */
        private void sleepUnlessRunAfter(int seen) {
            asleep = true;
            if (run == seen && !closed) {
                LockSupport.park(ThreadLanes.this);
            }
            asleep = false;
        }
    }
}
