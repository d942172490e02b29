package org.auvsim.experiments.hidden;

import java.util.ArrayList;
import java.util.List;

/** Samples at which something new is commanded. */
final class Steps {
    private Steps() {}

    /** From sample 0 on with pauses between two bounds (s). */
    static List<Integer> draw(
            double duration, int rate, double shortest, double longest, Draws draws) {
        List<Integer> samples = new ArrayList<>(List.of(0));
        double next = draws.between(0.3, 1);
        while (next < duration) {
            samples.add((int) Math.ceil(next * rate));
            next += draws.between(shortest, longest);
        }
        return samples;
    }
}
