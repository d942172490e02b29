package org.auvsim.experiments.bench;

import static java.nio.charset.StandardCharsets.UTF_8;

import de.siegmar.fastcsv.writer.CsvWriter;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/** Measurements as CSV, all digits of them. */
public final class BenchCsv {
    private BenchCsv() {}

    /** Writes a file of them. */
    public static void write(Path file, List<Measurement> measurements) throws IOException {
        try (CsvWriter csv = CsvWriter.builder().build(file, UTF_8)) {
            csv.writeRecord(
                    "bodies",
                    "seed",
                    "restitution",
                    "world_s",
                    "repetitions",
                    "best_s",
                    "median_s",
                    "times_real_time",
                    "collisions",
                    "events",
                    "body_steps_per_s",
                    "ns_per_body_step",
                    "peak_memory_bytes",
                    "energy_drift_percent",
                    "largest_overlap_radii");
            measurements.forEach(m -> csv.writeRecord(row(m)));
        }
    }

    private static List<String> row(Measurement m) {
        return List.<Object>of(
                        m.bodies(),
                        m.workload().seed(),
                        m.workload().restitution(),
                        m.seconds(),
                        m.wallSeconds().size(),
                        m.best(),
                        m.median(),
                        m.timesRealTime(),
                        m.statistics().collisions(),
                        m.statistics().events(),
                        m.bodyStepsPerSecond(),
                        m.nanosPerBodyStep(),
                        m.peakBytes(),
                        m.energyDrift(),
                        m.largestOverlap())
                .stream()
                .map(Object::toString)
                .toList();
    }
}
