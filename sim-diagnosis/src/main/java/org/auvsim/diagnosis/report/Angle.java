package org.auvsim.diagnosis.report;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.EulerAngles;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.Optional;
import java.util.function.IntFunction;

/** Angles of an orientation: first the heading, then the pitch, then the roll (z, y', x''). */
enum Angle {
    /** About x. */
    ROLL,
    /** About y. */
    PITCH,
    /** About z. */
    YAW;

    /** About which it turns, 0 to 2. */
    int axis() {
        return switch (this) {
            case ROLL -> 0;
            case PITCH -> 1;
            case YAW -> 2;
        };
    }

    String words() {
        return switch (this) {
            case ROLL -> "Roll";
            case PITCH -> "Pitch";
            case YAW -> "Heading";
        };
    }

    /** In rad; NaN of none. */
    private double of(Quat q) {
        Vec3 angles = EulerAngles.of(q);
        return switch (this) {
            case ROLL -> angles.x();
            case PITCH -> angles.y();
            case YAW -> angles.z();
        };
    }

    /** Sample by sample, without jumps by whole turns. */
    double[] course(int size, IntFunction<Quat> orientations) {
        double[] course = new double[size];
        double last = size == 0 ? 0 : of(orientations.apply(0));
        for (int k = 0; k < size; k++) {
            course[k] = near(last, of(orientations.apply(k)));
            last = course[k];
        }
        return course;
    }

    /**
     * The measured angles, NaN where another was measured alone, the first within half a turn of
     * that of an orientation, if one is given and of a motion that did not get lost.
     */
    double[] measured(MeasuredRun run, Optional<Quat> nearby) {
        double[] course = new double[run.size()];
        double last = nearby.map(this::of).filter(Double::isFinite).orElse(0.0);
        for (int k = 0; k < course.length; k++) {
            double before = last;
            boolean isMeasured = !Double.isNaN(run.value(Channel.ORIENTATION, k, axis()));
            course[k] =
                    run.orientation(k)
                            .filter(_ -> isMeasured)
                            .map(q -> near(before, of(q)))
                            .orElse(Double.NaN);
            last = Double.isNaN(course[k]) ? last : course[k];
        }
        return course;
    }

    private static double near(double other, double angle) {
        return other + Math.IEEEremainder(angle - other, 2 * Math.PI);
    }
}
