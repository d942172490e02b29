package org.auvsim.cli;

import java.io.PrintWriter;
import java.util.function.LongSupplier;

/** Says every two seconds how far a long run is; a short one stays silent. */
final class Progress {
    private static final long EVERY = 2_000_000_000L;

    private final double from;
    private final double until;
    private final PrintWriter out;
    private final LongSupplier nanos;
    private final long began;
    private long next;

    /** For a run over world times {@code from} to {@code until} (s) that begins now. */
    Progress(double from, double until, PrintWriter out, LongSupplier nanos) {
        this.from = from;
        this.until = until;
        this.out = out;
        this.nanos = nanos;
        this.began = nanos.getAsLong();
        this.next = began + EVERY;
    }

    /** The run has come to this world time (s). */
    void at(double time) {
        long now = nanos.getAsLong();
        if (now - next < 0) {
            return;
        }
        next = now + EVERY;
        double share = 100 * (time - from) / (until - from);
        double speed = (time - from) / ((now - began) * 1e-9);
        out.printf(
                "at %.1f s of %.1f s (%.0f %%), %.3g times real time%n", time, until, share, speed);
        out.flush();
    }
}
