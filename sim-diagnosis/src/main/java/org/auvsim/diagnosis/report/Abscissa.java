package org.auvsim.diagnosis.report;

import org.auvsim.core.math.Vec3;
import org.auvsim.server.feedback.RigidMotion;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * A part of a body's state over which is shown what a model misses: what depends on it lies on a
 * line there, however it looks over time.
 */
final class Abscissa {
    /** Ranges below this (SI) are those of rounding: nothing is shown over what does not change. */
    private static final double STILL = 1e-6;

    private final String title;
    private final String label;

    /** By axis (x, y, z) and sample. */
    private final double[][] values;

    private Abscissa(String title, String label, double[][] values) {
        this.title = title;
        this.label = label;
        this.values = values;
    }

    /**
     * What misses of a position or force may depend on: those along the same axis, and an angle.
     */
    static List<Abscissa> ofWays(List<RigidMotion> told) {
        return changing(
                of("velocity", "velocity along the same axis (m/s)", told, RigidMotion::velocity),
                of("position", "position along the same axis (m)", told, RigidMotion::position),
                angle(told));
    }

    /** What misses of an orientation may depend on: the rate about the same axis, and so on. */
    static List<Abscissa> ofTurns(List<RigidMotion> told) {
        return changing(
                of(
                        "angular velocity",
                        "angular velocity about the same axis (rad/s)",
                        told,
                        RigidMotion::angularVelocity),
                of("position", "position along the same axis (m)", told, RigidMotion::position),
                angle(told));
    }

    /** Its name, as in "over the velocity". */
    String title() {
        return title;
    }

    /** The same with what it is taken along and its unit. */
    String label() {
        return label;
    }

    double at(int sample, int axis) {
        return values[axis][sample];
    }

    private static List<Abscissa> changing(Abscissa... all) {
        return Stream.of(all).filter(Abscissa::changes).toList();
    }

    private boolean changes() {
        return Arrays.stream(values).anyMatch(ofAxis -> range(ofAxis) > STILL);
    }

    private static Abscissa of(
            String title, String label, List<RigidMotion> told, Function<RigidMotion, Vec3> part) {
        double[][] values = new double[3][told.size()];
        for (int k = 0; k < told.size(); k++) {
            for (int axis = 0; axis < 3; axis++) {
                values[axis][k] = part.apply(told.get(k)).component(axis);
            }
        }
        return new Abscissa(title, label, values);
    }

    /** The angle that changes most. */
    private static Abscissa angle(List<RigidMotion> told) {
        return Stream.of(Angle.values())
                .map(angle -> of(angle, told))
                .max(Comparator.comparingDouble(angle -> range(angle.values[0])))
                .orElseThrow();
    }

    private static Abscissa of(Angle angle, List<RigidMotion> told) {
        double[] course = angle.course(told.size(), k -> told.get(k).orientation());
        String word = angle.words().toLowerCase(Locale.ROOT);
        return new Abscissa(word, word + " (rad)", new double[][] {course, course, course});
    }

    private static double range(double[] values) {
        double least = Arrays.stream(values).filter(Double::isFinite).min().orElse(0);
        return Arrays.stream(values).filter(Double::isFinite).max().orElse(0) - least;
    }
}
