package org.auvsim.cli;

import java.io.PrintWriter;
import java.util.Locale;
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

    /**
     * For a run over world times {@code from} to {@code until} (s) that begins now.
     *
     * @param until infinite if it is not known
     */
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
        String of =
                Double.isInfinite(until)
                        ? ""
                        : String.format(Locale.ROOT, " of %.1f s (%.0f %%)", until, share);
        out.printf(Locale.ROOT, "at %.1f s%s, %.3g times real time%n", time, of, speed);
        out.flush();
    }
}
