package org.auvsim.cli.demo;

import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;

/** The true and the simulated path of one flight, sample by sample. */
final class Track {
    /**
     * Both positions (m) at a time (s).
     *
     * @param corrected whether feedback corrected the simulated one at this very time
     */
    record Sample(double time, Vec3 truth, Vec3 simulated, boolean corrected) {
        double error() {
            return truth.distance(simulated);
        }
    }

    private final String name;
    private final List<Sample> samples = new ArrayList<>();

    Track(String name) {
        this.name = name;
    }

    String name() {
        return name;
    }

    void add(Sample sample) {
        samples.add(sample);
    }

    /** The part from one time to another (s), under a name of its own. */
    Track part(String name, double from, double until) {
        Track part = new Track(name);
        samples.stream().filter(s -> s.time() >= from && s.time() < until).forEach(part::add);
        return part;
    }

    /** The samples where no feedback came. */
    Track uncorrected() {
        Track part = new Track(name);
        samples.stream().filter(s -> !s.corrected()).forEach(part::add);
        return part;
    }

    List<Sample> samples() {
        return List.copyOf(samples);
    }

    /** Root mean square of the distance (m) at the samples where no feedback came. */
    double rmsError() {
        return Math.sqrt(
                samples.stream()
                        .filter(s -> !s.corrected())
                        .mapToDouble(s -> s.error() * s.error())
                        .average()
                        .orElseThrow());
    }

    /** The largest distance (m) at the samples where no feedback came. */
    double largestError() {
        return samples.stream()
                .filter(s -> !s.corrected())
                .mapToDouble(Sample::error)
                .max()
                .orElseThrow();
    }

    long corrections() {
        return samples.stream().filter(Sample::corrected).count();
    }
}
