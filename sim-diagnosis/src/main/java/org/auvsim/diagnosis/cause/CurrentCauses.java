package org.auvsim.diagnosis.cause;

import org.auvsim.core.field.OscillatingCurrent;
import org.auvsim.core.field.ShearCurrent;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.field.VortexCurrent;
import org.auvsim.core.field.VortexProfile;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.Variant;

import java.util.ArrayList;
import java.util.List;

/** Water that moves otherwise than the model's. */
final class CurrentCauses {
    /** Ids of found currents begin beyond those that scenarios usually have. */
    private static final long FIRST_ID = 1_000_001;

    /** Cores of vortices to begin with, as shares of the range. */
    private static final double[] CORES = {0.15, 0.4};

    private static final int VORTICES = 4;

    private CurrentCauses() {}

    static List<Cause> of(Setting s) {
        double scale = s.scale("m/s");
        return List.of(
                Change.of(
                        "current_constant",
                        Parameter.vector("u", "m/s", scale),
                        (v, t) -> v.in(new UniformCurrent(id(s, v), name(s, v), vector(t, 0)))),
                oscillating(s, scale),
                shear(s, scale),
                vortex(s, scale));
    }

    /** No current has it, also if some were found before. */
    private static long id(Setting s, Variant v) {
        return FIRST_ID + count(s, v);
    }

    private static String name(Setting s, Variant v) {
        return "found current " + (count(s, v) + 1);
    }

    private static int count(Setting s, Variant v) {
        return s.model().scenario().field().size() + v.currents().size();
    }

    private static Vec3 vector(double[] theta, int from) {
        return new Vec3(theta[from], theta[from + 1], theta[from + 2]);
    }

    /** Of a sine and a cosine, as both are linear. */
    private static Cause oscillating(Setting s, double scale) {
        Oscillation oscillation = Oscillation.ofCurrent(s, scale);
        return Change.of(
                        "current_oscillating",
                        oscillation.parameters(),
                        (v, t) ->
                                swinging(
                                        s,
                                        swinging(
                                                s, v, oscillation.sine(t), t[Oscillation.OMEGA], 0),
                                        oscillation.cosine(t),
                                        t[Oscillation.OMEGA],
                                        Math.PI / 2))
                .from(oscillation.guesses(new Frequencies(s).all()))
                .withAliases(oscillation::aliases)
                .told(oscillation::quantities);
    }

    private static Variant swinging(
            Setting s, Variant v, Vec3 amplitude, double omega, double phase) {
        return amplitude.equals(Vec3.ZERO)
                ? v
                : v.in(
                        new OscillatingCurrent(
                                id(s, v),
                                name(s, v),
                                Vec3.ZERO,
                                amplitude,
                                2 * Math.PI / omega,
                                phase));
    }

    private static Cause shear(Setting s, double scale) {
        double height = Math.max(0.1 * s.path().range(), s.path().high().z() - s.path().low().z());
        return Change.of(
                "current_shear",
                List.of(
                        Parameter.signed("rate.x", "1/s", scale / height),
                        Parameter.signed("rate.y", "1/s", scale / height)),
                (v, t) ->
                        v.in(
                                new ShearCurrent(
                                        id(s, v),
                                        name(s, v),
                                        Vec3.ZERO,
                                        0,
                                        new Vec3(t[0], t[1], 0))));
    }

    /**
     * Its circulation is searched for as the speed of its water along the path, on average: that is
     * nearly the same wherever the vortex may be.
     */
    private static Cause vortex(Setting s, double scale) {
        Path path = s.path();
        double range = path.range();
        List<Parameter> parameters =
                List.of(
                        Parameter.signed("centre.x", "m", 0.1 * range),
                        Parameter.signed("centre.y", "m", 0.1 * range),
                        Parameter.signed("speed", "m/s", scale),
                        new Parameter("core", "m", 0.1 * range, 0.01 * range, 10 * range));
        List<Guess> guesses = new ArrayList<>();
        Vec3 low = path.centre().minus(new Vec3(range, range, 0).times(0.75));
        for (int i = 0; i < VORTICES; i++) {
            for (int j = 0; j < VORTICES; j++) {
                for (double core : CORES) {
                    double x = low.x() + 1.5 * range * (i + 0.5) / VORTICES;
                    double y = low.y() + 1.5 * range * (j + 0.5) / VORTICES;
                    guesses.add(Change.guess(parameters, new double[] {x, y, 0, core * range}, 2));
                }
            }
        }
        return Change.of(
                        "current_vortex",
                        parameters,
                        (v, t) ->
                                v.in(
                                        new VortexCurrent(
                                                id(s, v),
                                                name(s, v),
                                                t[0],
                                                t[1],
                                                circulation(path, t),
                                                t[3],
                                                VortexProfile.KAUFMANN)))
                .from(guesses)
                .told(
                        t ->
                                List.of(
                                        new Quantity("centre.x", "m", t[0]),
                                        new Quantity("centre.y", "m", t[1]),
                                        new Quantity("gamma", "m^2/s", circulation(path, t)),
                                        new Quantity("core", "m", t[3])));
    }

    private static double circulation(Path path, double[] theta) {
        return theta[2]
                / path.mean(
                        p -> {
                            double x = p.x() - theta[0];
                            double y = p.y() - theta[1];
                            double square = x * x + y * y;
                            double beside = square + theta[3] * theta[3];
                            return Math.sqrt(square) / (2 * Math.PI * beside);
                        });
    }
}
