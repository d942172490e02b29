package org.auvsim.server.replay;

import org.auvsim.auvsml.document.recording.RecordingWriter;
import org.auvsim.auvsml.recording.Entry;
import org.auvsim.auvsml.recording.RecordingEnded;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/**
 * Entries on their way from the simulation thread to the file: bounded, written by a thread of its
 * own, and handed to the operating system at least once a second.
 */
final class EntryQueue {
    private static final Logger LOG = LoggerFactory.getLogger(EntryQueue.class);
    private static final int CAPACITY = 1024;
    private static final long PATIENCE_SECONDS = 2;
    private static final long FLUSH_NANOS = 1_000_000_000L;

    /** The writing thread looks this often whether the end has come. */
    private static final long LOOK_NANOS = 20_000_000L;

    private final RecordingWriter writer;
    private final BlockingQueue<Entry> entries = new ArrayBlockingQueue<>(CAPACITY);
    private final Thread thread = new Thread(this::write, "recording");

    /** Why it ends; empty while it goes on. Guarded by this, as those below. */
    private Optional<String> end = Optional.empty();

    /** Why it is not whole, if so. */
    private Optional<String> failure = Optional.empty();

    private Optional<Consumer<String>> listener = Optional.empty();

    /** The place of the entry written last; the writing thread's. */
    private int revision;

    private long step;

    private double time;

    /** Writes to {@code writer}, and closes it, what happens from this world time (s) on. */
    EntryQueue(RecordingWriter writer, double startTime) {
        this.writer = writer;
        this.time = startTime;
        thread.setDaemon(true); // a program that forgets to close it can end all the same
        thread.start();
    }

    /** Takes an entry; it goes nowhere if the recording has ended. */
    void put(Entry entry) {
        if (hasEnded()) {
            return;
        }
        try {
            if (!entries.offer(entry, PATIENCE_SECONDS, TimeUnit.SECONDS)) {
                endEarly(
                        "the file takes entries too slowly: %d have waited for %d s"
                                .formatted(CAPACITY, PATIENCE_SECONDS));
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            endEarly("the simulation was interrupted");
        }
    }

    private synchronized boolean hasEnded() {
        return end.isPresent();
    }

    private synchronized void endEarly(String reason) {
        if (failure.isEmpty()) {
            LOG.error("the recording ends: {}", reason);
            failure = Optional.of(reason);
            end = end.or(() -> failure);
            tellEnd();
        }
    }

    /** Says whom to tell, on a thread of their own, if it ends by itself. */
    synchronized void whenEnded(Consumer<String> listener) {
        this.listener = Optional.of(listener);
        tellEnd();
    }

    private void tellEnd() {
        if (failure.isPresent() && listener.isPresent()) {
            String reason = failure.get();
            Consumer<String> told = listener.get();
            Thread.startVirtualThread(() -> told.accept(reason));
        }
    }

    /** Why it is not whole; empty as long as it is. */
    synchronized Optional<String> failure() {
        return failure;
    }

    /** Ends it for this reason, unless it has ended, and waits until all is written. */
    void close(String reason) {
        synchronized (this) {
            end = end.or(() -> Optional.of(reason));
        }
        try {
            thread.join();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void write() {
        try (writer) {
            writeUntilEnd();
            writer.write(new RecordingEnded(revision, step, time, endReason()));
        } catch (IOException | RuntimeException e) {
            endEarly("it cannot be written: " + e.getMessage());
        } catch (InterruptedException e) {
            endEarly("its writing was interrupted");
        }
    }

    private synchronized String endReason() {
        return end.orElseThrow();
    }

    private void writeUntilEnd() throws IOException, InterruptedException {
        long nextFlush = System.nanoTime() + FLUSH_NANOS;
        while (true) {
            boolean isLast = hasEnded();
            @Nullable Entry entry = entries.poll(isLast ? 0 : LOOK_NANOS, TimeUnit.NANOSECONDS);
            if (entry != null) {
                writer.write(entry);
                revision = entry.revision();
                step = entry.step();
                time = entry.timestamp();
            } else if (isLast) {
                return;
            }
            if (System.nanoTime() - nextFlush >= 0) {
                writer.flush();
                nextFlush = System.nanoTime() + FLUSH_NANOS;
            }
        }
    }
}
