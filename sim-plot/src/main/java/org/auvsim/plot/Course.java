package org.auvsim.plot;

import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** Where an object has been; of a long run every second, fourth ... sample is kept. */
public final class Course {
    private static final int MOST_SAMPLES = 4000;

    /** Time (s), position (m) and speed (m/s), which is NaN where nobody knows it. */
    public record Sample(double time, Vec3 position, double speed) {}

    private final String name;
    private List<Sample> samples = new ArrayList<>();
    private int stride = 1;
    private int seen;

    /** An empty course; the name stands in the legend. */
    public Course(String name) {
        this.name = name;
    }

    String name() {
        return name;
    }

    /** Goes on to a later time. */
    public void add(Sample sample) {
        if (seen++ % stride != 0) {
            return;
        }
        samples.add(sample);
        if (samples.size() == MOST_SAMPLES) {
            List<Sample> fewer = new ArrayList<>();
            for (int i = 0; i < samples.size(); i += 2) {
                fewer.add(samples.get(i));
            }
            samples = fewer;
            stride *= 2;
        }
    }

    double[] values(ToDoubleFunction<Sample> of) {
        return samples.stream().mapToDouble(of).toArray();
    }
}
