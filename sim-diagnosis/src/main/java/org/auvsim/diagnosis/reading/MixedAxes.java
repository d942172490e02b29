package org.auvsim.diagnosis.reading;

import org.auvsim.core.math.Vec3;

import java.util.Optional;

/** How columns of positions are mixed up, or told positive the other way. */
enum MixedAxes {
    /** North and east, latitude and longitude. */
    X_AND_Y("x and y were swapped"),

    /** Where one program has y upwards and another z. */
    Y_AND_Z("y and z were swapped"),

    /** Rarely. */
    X_AND_Z("x and z were swapped"),

    /** Backward. */
    X("x were positive the other way"),

    /** To the right, where all else is to the left. */
    Y("y were positive the other way"),

    /** A depth. */
    Z("z were positive the other way");

    private final String words;

    MixedAxes(String words) {
        this.words = words;
    }

    /** A position that was told so, as it is. */
    Vec3 unmixed(Vec3 told) {
        double x = told.x();
        double y = told.y();
        double z = told.z();
        return switch (this) {
            case X_AND_Y -> new Vec3(y, x, z);
            case Y_AND_Z -> new Vec3(x, z, y);
            case X_AND_Z -> new Vec3(z, y, x);
            case X -> new Vec3(-x, y, z);
            case Y -> new Vec3(x, -y, z);
            case Z -> new Vec3(x, y, -z);
        };
    }

    /** The axis (0 to 2) that is positive the other way, if it is that. */
    Optional<Integer> turnsRound() {
        return switch (this) {
            case X_AND_Y, Y_AND_Z, X_AND_Z -> Optional.empty();
            case X -> Optional.of(0);
            case Y -> Optional.of(1);
            case Z -> Optional.of(2);
        };
    }

    /** What is seen where the model moves as runs that are told so. */
    Suspicion suspicion() {
        String remedy =
                switch (this) {
                    case X_AND_Y, Y_AND_Z, X_AND_Z ->
                            ": are these columns mixed up? If so, map them (--mapping)";
                    case X, Y, Z ->
                            ": is it? If so, map that column with a scale of -1 (--mapping)";
                };
        return new Suspicion(
                "the model moves as this does if " + words,
                remedy,
                ", but it is explained as it was read");
    }
}
