package org.auvsim.diagnosis.reading;

import org.auvsim.core.math.Vec3;

import java.util.function.UnaryOperator;

/** How columns of positions are mixed up, or told positive the other way. */
enum MixedAxes {
    /** North and east, latitude and longitude. */
    X_AND_Y("x and y were swapped", p -> new Vec3(p.y(), p.x(), p.z()), MixedAxes.SWAPPED),

    /** Where one program has y upwards and another z. */
    Y_AND_Z("y and z were swapped", p -> new Vec3(p.x(), p.z(), p.y()), MixedAxes.SWAPPED),

    /** Rarely. */
    X_AND_Z("x and z were swapped", p -> new Vec3(p.z(), p.y(), p.x()), MixedAxes.SWAPPED),

    /** Backward. */
    X("x were positive the other way", p -> new Vec3(-p.x(), p.y(), p.z()), MixedAxes.MIRRORED),

    /** To the right, where all else is to the left. */
    Y("y were positive the other way", p -> new Vec3(p.x(), -p.y(), p.z()), MixedAxes.MIRRORED),

    /** A depth. */
    Z("z were positive the other way", p -> new Vec3(p.x(), p.y(), -p.z()), MixedAxes.MIRRORED);

    private static final String SWAPPED =
            ": are these columns mixed up? If so, map them (--mapping)";
    private static final String MIRRORED =
            ": is it, as a depth is? If so, map that column with a scale of -1 (--mapping)";

    private final String words;
    private final UnaryOperator<Vec3> unmixed;
    private final String question;

    MixedAxes(String words, UnaryOperator<Vec3> unmixed, String question) {
        this.words = words;
        this.unmixed = unmixed;
        this.question = question;
    }

    /** A position that was told so, as it is. */
    Vec3 unmixed(Vec3 told) {
        return unmixed.apply(told);
    }

    /** What is seen where the model moves as runs that are told so. */
    Suspicion suspicion() {
        return new Suspicion(
                "the model moves as this does if " + words,
                question,
                ", but it is explained as it was read");
    }
}
