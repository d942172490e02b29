package org.auvsim.diagnosis.cause;

import org.auvsim.core.effect.Kick;
import org.auvsim.core.effect.StepForce;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/** What happens at one time: a force that begins, an impulse. */
final class OnsetCauses {
    /** Time steps over which they are spread: enough for the integrator, hardly seen in data. */
    static final double STEPS = 3;

    private static final int TIMES = 24;

    /** Moments to either side of one that was found, until the next of those. */
    private static final int NEARBY = 8;

    private OnsetCauses() {}

    static List<Cause> of(Setting s) {
        double spread = STEPS * s.timeStep();
        return List.of(
                begun(
                        s,
                        "step_force",
                        "from",
                        s.forces("force", "N", s.force()),
                        (v, t) -> v.with(b -> b.effect(new StepForce(vector(t), t[3], spread)))),
                begun(
                        s,
                        "impulse",
                        "at",
                        s.forces("impulse", "N s", 0.1 * s.scale("N s")),
                        (v, t) -> v.with(b -> b.effect(new Kick(vector(t), t[3], spread)))));
    }

    private static Vec3 vector(double[] theta) {
        return new Vec3(theta[0], theta[1], theta[2]);
    }

    private static Cause begun(
            Setting s, String id, String instant, List<Parameter> strength, Change.Law law) {
        List<Parameter> parameters = new ArrayList<>(strength);
        parameters.add(
                new Parameter(
                        instant,
                        "s",
                        0.02 * s.path().duration(),
                        s.path().begin(),
                        s.path().end()));
        return Change.of(id, parameters, law)
                .from(guesses(parameters, Arrays.stream(s.path().times(TIMES))))
                .withAliases(theta -> guesses(parameters, nearby(theta[3], s.path())));
    }

    private static List<Guess> guesses(List<Parameter> parameters, DoubleStream times) {
        return times.mapToObj(t -> Change.guess(parameters, new double[] {0, 0, 0, t}, 0, 1, 2))
                .toList();
    }

    /**
     * A search that begins half a period away from the moment, or further, of what swings, ends at
     * another: with the force the other way, for one.
     */
    private static DoubleStream nearby(double time, Path path) {
        double apart = path.total() / TIMES / NEARBY;
        return IntStream.rangeClosed(-NEARBY, NEARBY)
                .mapToDouble(i -> time + i * apart)
                .filter(t -> path.begin() <= t && t <= path.end());
    }
}
