package org.auvsim.cli.demo;

import org.auvsim.core.math.Vec3;

import java.io.PrintWriter;
import java.util.Locale;

/** The table that grows while the robot flies, and the one at the end. */
final class LiveTable {
    private static final double ROW_EVERY = 4;
    private static final double LONG_ROW_EVERY = 8;

    /** Rows show the time just between two corrections, not the moment after one. */
    private static final double FIRST_ROW = 3.75;

    private final PrintWriter out;
    private double nextRow;
    private double rowEvery = ROW_EVERY;

    LiveTable(PrintWriter out) {
        this.out = out;
    }

    /** Begins the rows of a flight of one round. */
    void begin(Track track) {
        begin(track, ROW_EVERY);
    }

    /** Begins the rows, fewer of them, of a flight of many rounds. */
    void beginLong(Track track) {
        begin(track, LONG_ROW_EVERY);
    }

    private void begin(Track track, double every) {
        nextRow = FIRST_ROW;
        rowEvery = every;
        out.printf(Locale.ROOT, "%n%s%n", track.name());
        out.printf(
                "  %6s   %-24s %-24s %9s %12s%n",
                "time", "true position", "simulated position", "error", "corrections");
        out.flush();
    }

    /** Shows a sample if it is time for a row. */
    void show(Track track, Track.Sample sample) {
        if (sample.time() < nextRow - 1e-9) {
            return;
        }
        nextRow += rowEvery;
        out.printf(
                Locale.ROOT,
                "  %5.2f s  %-24s %-24s %7.3f m %12d%n",
                sample.time(),
                text(sample.truth()),
                text(sample.simulated()),
                sample.error(),
                track.corrections());
        out.flush();
    }

    private static String text(Vec3 p) {
        return String.format(Locale.ROOT, "%6.2f %6.2f %6.2f m", p.x(), p.y(), p.z());
    }

    /** The errors of all flights side by side. */
    void summary(Iterable<Track> tracks) {
        out.printf(
                "%n%-22s %12s %12s %14s%n",
                "simulation", "corrections", "RMS error", "largest error");
        for (Track track : tracks) {
            out.printf(
                    Locale.ROOT,
                    "%-22s %12d %10.3f m %12.3f m%n",
                    track.name(),
                    track.corrections(),
                    track.rmsError(),
                    track.largestError());
        }
        out.flush();
    }
}
