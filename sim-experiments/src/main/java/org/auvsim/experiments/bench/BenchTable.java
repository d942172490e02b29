package org.auvsim.experiments.bench;

import java.util.List;
import java.util.Locale;

/** Measurements as lines of text. */
public final class BenchTable {
    private BenchTable() {}

    /** The two lines above the first measurement. */
    public static List<String> header() {
        return List.of(
                "  bodies   world     best   median    times real                            "
                        + "  body-steps  ns a body-  memory    energy    overlap",
                "             s     s         s            time   collisions       events"
                        + "    a second        step      MB         %      radii");
    }

    /** One measurement. */
    public static String row(Measurement m) {
        return String.format(
                Locale.ROOT,
                "%8d %7.4g %8.4g %8.4g %13.5g %12d %12d %11.4g %11.4g %7.0f %9.2g %10.2g",
                m.bodies(),
                m.seconds(),
                m.best(),
                m.median(),
                m.timesRealTime(),
                m.statistics().collisions(),
                m.statistics().events(),
                m.bodyStepsPerSecond(),
                m.nanosPerBodyStep(),
                m.peakBytes() * 1e-6,
                m.energyDrift(),
                m.largestOverlap());
    }
}
