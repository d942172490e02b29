package org.auvsim.server.simulator;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/**
 * What other threads bring for the simulation thread to take, in order. It is bounded: who brings
 * too much has to wait.
 */
final class Mailbox implements InputSource {
    private final int capacity;
    private final Queue<Input> inputs = new ArrayDeque<>();
    private final ReentrantLock lock = new ReentrantLock(/* fair= */ true);
    private final Condition filled = lock.newCondition();
    private final Condition emptied = lock.newCondition();
    private boolean closed;

    /** Holds so many inputs at a time. */
    Mailbox(int capacity) {
        this.capacity = capacity;
    }

    /** Brings an input; false if the mailbox is closed and nobody will see it. */
    boolean post(Input input) throws InterruptedException {
        lock.lockInterruptibly();
        try {
            while (!closed && inputs.size() >= capacity) {
                emptied.await();
            }
            if (!closed) {
                inputs.add(input);
                filled.signal();
            }
            return !closed;
        } finally {
            lock.unlock();
        }
    }

    /**
     * Takes what is there, after waiting at most so long (ns) for something to be there.
     *
     * @param most so many are taken; the others stay
     */
    List<Input> take(int most, long nanos) throws InterruptedException {
        lock.lockInterruptibly();
        try {
            await(nanos);
            List<Input> taken = new ArrayList<>();
            for (int left = Math.min(most, inputs.size()); left > 0; left--) {
                taken.add(inputs.remove());
            }
            emptied.signalAll();
            return taken;
        } finally {
            lock.unlock();
        }
    }

    @Override
    public Optional<Input> next(long nanos) throws InterruptedException {
        return take(1, nanos).stream().findFirst();
    }

    private void await(long nanos) throws InterruptedException {
        long left = nanos;
        while (inputs.isEmpty() && !closed && left > 0) {
            left = filled.awaitNanos(left);
        }
    }

    /** Takes nothing more; what is there is forgotten, and nobody waits any longer. */
    void close() {
        lock.lock();
        try {
            closed = true;
            inputs.clear();
            filled.signalAll();
            emptied.signalAll();
        } finally {
            lock.unlock();
        }
    }

    @Override
    public boolean isClosed() {
        lock.lock();
        try {
            return closed;
        } finally {
            lock.unlock();
        }
    }
}
