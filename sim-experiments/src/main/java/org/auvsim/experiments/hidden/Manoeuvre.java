package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

import java.util.List;

/**
 * What is done with a body in one run.
 *
 * @param start how it moves at time 0, in still water
 * @param duration (s)
 * @param rate of measurements (Hz)
 * @param commands each is told anew at samples only
 * @param pushes from outside, known to the diagnosis
 */
record Manoeuvre(
        Instant start, double duration, int rate, List<Track> commands, List<TimedPush> pushes) {
    /** What a thruster or fin is told: levels[i] from samples[i] on. */
    record Track(String name, List<Integer> samples, List<Double> levels) {
        double level(int sample) {
            double level = 0;
            for (int i = 0; i < samples.size() && samples.get(i) <= sample; i++) {
                level = levels.get(i);
            }
            return level;
        }
    }

    /** A force (N, world axes) at a point of the body (m) for a while (s). */
    record TimedPush(double from, double until, Vector3D force, Vector3D point) {}

    /** Number of measurements. */
    int samples() {
        return (int) Math.round(duration * rate) + 1;
    }

    double time(int sample) {
        return (double) sample / rate;
    }

    /** The same from another start. */
    Manoeuvre from(Instant elsewhere) {
        return new Manoeuvre(elsewhere, duration, rate, commands, pushes);
    }
}
