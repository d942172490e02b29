package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.shooting.Shooting;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.server.feedback.RigidMotion;

import java.util.List;
import java.util.stream.IntStream;

/** A fit, and the motion in each of its windows. */
final class Simulated {
    private final Fit fit;
    private final List<List<RigidMotion[]>> motions;

    private Simulated(Fit fit, List<List<RigidMotion[]>> motions) {
        this.fit = fit;
        this.motions = motions;
    }

    static Simulated of(Fit fit) {
        return new Simulated(
                fit,
                IntStream.range(0, fit.data().size())
                        .parallel()
                        .mapToObj(r -> motions(fit, r))
                        .toList());
    }

    private static List<RigidMotion[]> motions(Fit fit, int run) {
        Shooting shooting = fit.shooting(fit.data().get(run));
        return fit.windows().get(run).parallelStream().map(shooting::motion).toList();
    }

    Fit fit() {
        return fit;
    }

    Window window(int run, int number) {
        return fit.windows().get(run).get(number);
    }

    RigidMotion[] motion(int run, int number) {
        return motions.get(run).get(number);
    }

    /** What it misses, of one window a run. */
    Judged judged() {
        return Judged.of(fit, fit.outcome(motions.stream().map(List::getFirst).toList()));
    }
}
