package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.residual.Looseness;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Window;

import java.util.List;
import java.util.stream.IntStream;

/**
 * Windows that begin about as fast as the run is seen to move. What a model lacks may be made up
 * for by starts that no body has, as ten times its speed for a sensor that is not where it is said
 * to be; what such a motion needs says nothing of what the data needs.
 */
public final class OrdinaryWindows {
    private OrdinaryWindows() {}

    /** The same fit with those windows alone; of a run that has none, with all. */
    public static Fit of(Fit following, Noise noise) {
        return following.with(
                following.hypothesis(),
                IntStream.range(0, following.data().size())
                        .mapToObj(
                                r ->
                                        of(
                                                following.data().get(r).run(),
                                                following.windows().get(r),
                                                noise))
                        .toList());
    }

    private static List<Window> of(MeasuredRun run, List<Window> windows, Noise noise) {
        List<Double> looseness = Looseness.of(run, noise);
        double speed = looseness.get(6);
        double spin = looseness.get(9);
        List<Window> ordinary =
                windows.stream()
                        .filter(w -> w.start().velocity().norm() <= speed)
                        .filter(w -> w.start().angularVelocity().norm() <= spin)
                        .toList();
        return ordinary.isEmpty() ? windows : ordinary;
    }
}
