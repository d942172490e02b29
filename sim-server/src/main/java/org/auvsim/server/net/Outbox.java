package org.auvsim.server.net;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * What is on its way to one client, in the order of the wire, and bounded however slowly the client
 * reads.
 *
 * <p>State and control share one queue, so that their order holds. When states fill it, only the
 * newest on each topic is kept; the others are counted, and the client is told. Control is never
 * left out: a client for whom too much of it waits has to go.
 *
 * <p>The simulation thread puts in, the client's writer takes out.
 */
public final class Outbox {
    /** The most bytes that the writer gets at once, unless one message is longer. */
    private static final int LARGEST_PACKET = 64 << 10;

    private final int mostStates;
    private final int mostControl;
    private final long mostControlBytes;
    private Deque<Delivery> queue = new ArrayDeque<>();
    private int control;
    private long controlBytes;
    private int compactAt;
    private long skipped;
    private boolean closed;

    /**
     * An empty outbox.
     *
     * @param mostStates so many states may wait before older ones on the same topic are left out
     * @param mostControl so many responses, errors and events may wait
     * @param mostControlBytes so many bytes of them may wait
     */
    Outbox(int mostStates, int mostControl, long mostControlBytes) {
        this.mostStates = mostStates;
        this.mostControl = mostControl;
        this.mostControlBytes = mostControlBytes;
        this.compactAt = mostStates;
    }

    /**
     * Puts in messages that belong together, in order; those of a closed outbox go nowhere.
     *
     * @return false if too much control waits; then none is put in
     */
    synchronized boolean offer(List<Delivery> batch) {
        if (closed || batch.isEmpty()) {
            return true;
        }
        int added = (int) batch.stream().filter(Delivery::isControl).count();
        long addedBytes = batch.stream().mapToLong(Outbox::controlBytes).sum();
        boolean isTooMuch =
                control + added > mostControl || controlBytes + addedBytes > mostControlBytes;
        if (added > 0 && isTooMuch) {
            return false;
        }
        control += added;
        controlBytes += addedBytes;
        queue.addAll(batch);
        if (queue.size() - control > compactAt) {
            compact();
        }
        notifyAll();
        return true;
    }

    private static long controlBytes(Delivery delivery) {
        return delivery.isControl() ? delivery.bytes().length : 0;
    }

    /** Leaves out every state that a newer one on its topic follows. */
    private void compact() {
        int before = queue.size();
        Set<Topic> newer = new HashSet<>();
        Deque<Delivery> kept = new ArrayDeque<>();
        while (!queue.isEmpty()) {
            Delivery last = queue.removeLast();
            if (last.topic().map(newer::add).orElse(true)) {
                kept.addFirst(last);
            }
        }
        queue = kept;
        skipped += before - kept.size();
        compactAt = Math.max(mostStates, 2 * newer.size());
    }

    /** Throws away what waits, puts in a last message and closes. */
    synchronized void abort(byte[] lastMessage) {
        queue.clear();
        control = 0;
        controlBytes = 0;
        skipped = 0;
        queue.add(Delivery.control(lastMessage));
        close();
    }

    /** Takes nothing in any more; what waits can still be taken out. */
    synchronized void close() {
        closed = true;
        notifyAll();
    }

    /** Whether it takes nothing in any more. */
    synchronized boolean isClosed() {
        return closed;
    }

    /**
     * Waits for messages and takes those that wait, up to a packet's size.
     *
     * @return empty when the outbox is closed and nothing is left
     */
    synchronized Optional<Packet> take() throws InterruptedException {
        while (queue.isEmpty() && !closed) {
            wait();
        }
        if (queue.isEmpty()) {
            return Optional.empty();
        }
        List<byte[]> messages = new ArrayList<>();
        int size = 0;
        do {
            Delivery next = queue.remove();
            control -= next.isControl() ? 1 : 0;
            controlBytes -= controlBytes(next);
            size += next.bytes().length;
            messages.add(next.bytes());
        } while (!queue.isEmpty() && size + queue.element().bytes().length <= LARGEST_PACKET);
        Packet packet = new Packet(messages, skipped);
        skipped = 0;
        return Optional.of(packet);
    }

    /**
     * What the writer sends next.
     *
     * @param messages in order
     * @param skipped how many states have been left out since the packet before
     */
    record Packet(List<byte[]> messages, long skipped) {}
}
