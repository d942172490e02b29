package org.auvsim.server.simulator;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/**
 * What other threads want done by the simulation thread. Feedback lies apart from requests, so that
 * a step can take the one and leave the other. Both are bounded: who brings too much has to wait.
 */
final class Mailbox {
    private final int capacity;
    private final Queue<Runnable> requests = new ArrayDeque<>();
    private final Queue<Runnable> feedback = new ArrayDeque<>();
    private final ReentrantLock lock = new ReentrantLock(/* fair= */ true);
    private final Condition filled = lock.newCondition();
    private final Condition emptied = lock.newCondition();
    private boolean closed;

    /** Takes so many requests, and as many feedbacks, at a time. */
    Mailbox(int capacity) {
        this.capacity = capacity;
    }

    /** Brings a request; false if the mailbox is closed and nobody will see it. */
    boolean postRequest(Runnable request) throws InterruptedException {
        return post(requests, request);
    }

    /** Brings feedback; false if the mailbox is closed and nobody will see it. */
    boolean postFeedback(Runnable taking) throws InterruptedException {
        return post(feedback, taking);
    }

    private boolean post(Queue<Runnable> queue, Runnable task) throws InterruptedException {
        lock.lockInterruptibly();
        try {
            while (!closed && queue.size() >= capacity) {
                emptied.await();
            }
            if (!closed) {
                queue.add(task);
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
     * @param most so many requests, and as many feedbacks, are taken; the others stay
     */
    List<Runnable> take(int most, long nanos) throws InterruptedException {
        lock.lockInterruptibly();
        try {
            long left = nanos;
            while (requests.isEmpty() && feedback.isEmpty() && !closed && left > 0) {
                left = filled.awaitNanos(left);
            }
            List<Runnable> taken = new ArrayList<>();
            move(requests, most, taken);
            move(feedback, most, taken);
            emptied.signalAll();
            return taken;
        } finally {
            lock.unlock();
        }
    }

    private static void move(Queue<Runnable> from, int most, List<Runnable> to) {
        for (int left = Math.min(most, from.size()); left > 0; left--) {
            to.add(from.remove());
        }
    }

    /**
     * Takes the next feedback, after waiting at most so long (ns); requests stay where they are.
     */
    Optional<Runnable> takeFeedback(long nanos) throws InterruptedException {
        lock.lockInterruptibly();
        try {
            long left = nanos;
            while (feedback.isEmpty() && !closed && left > 0) {
                left = filled.awaitNanos(left);
            }
            emptied.signalAll();
            return Optional.ofNullable(feedback.poll());
        } finally {
            lock.unlock();
        }
    }

    /** Takes nothing more; what is there is forgotten, and nobody waits any longer. */
    void close() {
        lock.lock();
        try {
            closed = true;
            requests.clear();
            feedback.clear();
            filled.signalAll();
            emptied.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /** Whether it is closed. */
    boolean isClosed() {
        lock.lock();
        try {
            return closed;
        } finally {
            lock.unlock();
        }
    }
}
