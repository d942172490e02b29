package org.auvsim.diagnosis.cause;

import org.auvsim.core.effect.PeriodicForce;
import org.auvsim.core.effect.WaveForce;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Forces that come again and again. */
final class PeriodicCauses {
    private static final int DIRECTIONS = 4;
    private static final int FEWEST_WAVES = 12;

    private PeriodicCauses() {}

    static List<Cause> of(Setting s) {
        boolean alongX = Setting.goes(s.body(), new Vec3(1, 0, 0));
        boolean alongY = Setting.goes(s.body(), new Vec3(0, 1, 0));
        List<Cause> causes = new ArrayList<>();
        if (alongX && alongY) {
            causes.add(waves(s));
        } else if (alongX || alongY) {
            causes.add(wavesAlong(s, alongX ? 0 : Math.PI / 2));
        }
        causes.add(force(s));
        return causes;
    }

    private static Cause force(Setting s) {
        Oscillation oscillation = Oscillation.ofForce(s);
        return Change.of(
                        "periodic_force",
                        oscillation.parameters(),
                        (v, t) ->
                                v.with(
                                        b ->
                                                b.effect(
                                                        new PeriodicForce(
                                                                oscillation.sine(t),
                                                                oscillation.cosine(t),
                                                                t[Oscillation.OMEGA]))))
                .from(oscillation.guesses(new Frequencies(s).all()))
                .withAliases(oscillation::aliases)
                .told(oscillation::quantities)
                .asGeneric();
    }

    /**
     * Of a sine and a cosine, as both are linear. The wave number is told by its ratio to that of
     * deep water: 1 for waves that run, 0 for a force that is the same everywhere.
     */
    private static Cause waves(Setting s) {
        Frequencies frequencies = new Frequencies(s);
        List<Parameter> parameters =
                List.of(
                        Parameter.signed("sine", "N", s.force()),
                        Parameter.signed("cosine", "N", s.force()),
                        Parameter.signed("direction", "rad", 0.1),
                        frequencies.parameter(),
                        new Parameter("dispersion", "1", 0.1, 0, 10));
        List<Guess> guesses = new ArrayList<>();
        for (double omega : frequencies.told(FEWEST_WAVES)) {
            for (int i = 0; i < DIRECTIONS; i++) {
                double direction = 2 * Math.PI * i / DIRECTIONS;
                guesses.add(
                        Change.guess(parameters, new double[] {0, 0, direction, omega, 1}, 0, 1));
            }
        }
        for (double omega : frequencies.all()) {
            for (double direction : new double[] {0, Math.PI / 2}) {
                guesses.add(
                        Change.guess(parameters, new double[] {0, 0, direction, omega, 0}, 0, 1));
            }
        }
        double begin = s.path().begin();
        return Change.of(
                        "wave_forcing",
                        parameters,
                        (v, t) -> v.with(b -> b.effect(force(t, begin))))
                .from(guesses)
                .withAliases(
                        theta ->
                                Arrays.stream(frequencies.aliases(theta[3]))
                                        .mapToObj(w -> new double[] {0, 0, theta[2], w, theta[4]})
                                        .map(t -> Change.guess(parameters, t, 0, 1))
                                        .toList())
                .told(t -> quantities(t, begin));
    }

    /**
     * The same on a body that goes along one horizontal axis alone: only so much of their force is
     * felt. A wave number below 0 is that of waves which run against the axis.
     */
    private static Cause wavesAlong(Setting s, double direction) {
        Frequencies frequencies = new Frequencies(s);
        List<Parameter> parameters =
                List.of(
                        Parameter.signed("sine", "N", s.force()),
                        Parameter.signed("cosine", "N", s.force()),
                        frequencies.parameter(),
                        new Parameter("dispersion", "1", 0.1, -10, 10));
        List<Guess> guesses = new ArrayList<>();
        for (double omega : frequencies.told(FEWEST_WAVES)) {
            guesses.add(Change.guess(parameters, new double[] {0, 0, omega, 1}, 0, 1));
            guesses.add(Change.guess(parameters, new double[] {0, 0, omega, -1}, 0, 1));
        }
        for (double omega : frequencies.all()) {
            guesses.add(Change.guess(parameters, new double[] {0, 0, omega, 0}, 0, 1));
        }
        double begin = s.path().begin();
        return Change.of(
                        "wave_forcing",
                        parameters,
                        (v, t) -> v.with(b -> b.effect(forceAlong(direction, t, begin))))
                .from(guesses)
                .withAliases(
                        theta ->
                                Arrays.stream(frequencies.aliases(theta[2]))
                                        .mapToObj(w -> new double[] {0, 0, w, theta[3]})
                                        .map(t -> Change.guess(parameters, t, 0, 1))
                                        .toList())
                .told(
                        t ->
                                List.of(
                                        new Quantity(
                                                "amplitude", "N", StrictMath.hypot(t[0], t[1])),
                                        Quantity.frequency(t[2]),
                                        new Quantity("phase", "rad", phase(t, t[2], begin)),
                                        new Quantity(
                                                "wave_number",
                                                "rad/m",
                                                t[3] * t[2] * t[2] / Earth.GRAVITY)));
    }

    /**
     * By the world's time; sine and cosine count from where the runs begin, so that their phase
     * hardly changes with the frequency, whatever the clock shows.
     */
    private static double phase(double[] theta, double omega, double begin) {
        return StrictMath.IEEEremainder(
                StrictMath.atan2(theta[1], theta[0]) - omega * begin, 2 * Math.PI);
    }

    private static WaveForce forceAlong(double direction, double[] theta, double begin) {
        double against = theta[3] < 0 ? Math.PI : 0;
        return new WaveForce(
                StrictMath.hypot(theta[0], theta[1]),
                direction + against,
                theta[2],
                phase(theta, theta[2], begin) + against,
                Math.abs(theta[3]) * theta[2] * theta[2] / Earth.GRAVITY);
    }

    private static WaveForce force(double[] theta, double begin) {
        double omega = theta[3];
        return new WaveForce(
                StrictMath.hypot(theta[0], theta[1]),
                theta[2],
                omega,
                phase(theta, omega, begin),
                theta[4] * omega * omega / Earth.GRAVITY);
    }

    /** What is the same everywhere runs both ways: told as the one within half a turn of x. */
    private static WaveForce told(WaveForce force) {
        double half = force.waveNumber() == 0 ? Math.PI : 2 * Math.PI;
        double turns = Math.floor(force.direction() / half);
        boolean isTurned = half == Math.PI && turns % 2 != 0;
        double phase = force.phase() + (isTurned ? Math.PI : 0);
        return new WaveForce(
                force.amplitude(),
                force.direction() - turns * half,
                force.angularFrequency(),
                phase > Math.PI ? phase - 2 * Math.PI : phase,
                force.waveNumber());
    }

    private static List<Quantity> quantities(double[] theta, double begin) {
        WaveForce force = told(force(theta, begin));
        return List.of(
                new Quantity("amplitude", "N", force.amplitude()),
                new Quantity("direction", "rad", force.direction()),
                Quantity.frequency(force.angularFrequency()),
                new Quantity("phase", "rad", force.phase()),
                new Quantity("wave_number", "rad/m", force.waveNumber()));
    }
}
