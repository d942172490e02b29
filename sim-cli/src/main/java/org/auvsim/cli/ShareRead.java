package org.auvsim.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Locale;
import java.util.function.LongSupplier;

/** Says every two seconds how much of a long file has been read; a short one stays silent. */
final class ShareRead {
    private static final long EVERY = 2_000_000_000L;

    private final Path file;
    private final PrintWriter out;
    private final LongSupplier nanos;
    private long next;

    ShareRead(Path file, PrintWriter out, LongSupplier nanos) {
        this.file = file;
        this.out = out;
        this.nanos = nanos;
        this.next = nanos.getAsLong() + EVERY;
    }

    /** So much of it has been read, 0 to 1. */
    void at(double share) {
        long now = nanos.getAsLong();
        if (now - next < 0) {
            return;
        }
        next = now + EVERY;
        out.printf(Locale.ROOT, "%.0f %% of %s read%n", 100 * share, file);
        out.flush();
    }
}
