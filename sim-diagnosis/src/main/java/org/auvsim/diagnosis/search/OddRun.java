package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Whiteness;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Whether the model as it is believed misses one run alone, and predicts at least two others to
 * their noise: what a model lacks shows in more of them; another vehicle or load, in that run.
 */
public final class OddRun {
    private static final int FEWEST_OTHERS = 2;

    private OddRun() {}

    /** What is to be said of it; empty where no run is missed, or more than one, or few others. */
    public static Optional<String> notice(Judged... believed) {
        List<String> missed = new ArrayList<>();
        List<String> others = new ArrayList<>();
        for (Judged of : believed) {
            List<Misses> data = of.fit().data();
            for (int r = 0; r < data.size(); r++) {
                (isMissed(of, r) ? missed : others).add(data.get(r).run().name());
            }
        }
        return missed.size() != 1 || others.size() < FEWEST_OTHERS
                ? Optional.empty()
                : Optional.of(
                        "the model as it is predicts %s to the noise, and misses %s alone: was that another vehicle, or differently loaded, or did something happen to it? If so, leave it out, or diagnose it by itself"
                                .formatted(String.join(", ", others), missed.getFirst()));
    }

    private static boolean isMissed(Judged believed, int run) {
        return !(Whiteness.largest(
                        List.of(believed.outcome().misses().get(run)),
                        List.of(believed.fit().data().get(run)))
                < Whiteness.LIMIT);
    }
}
