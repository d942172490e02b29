package org.auvsim.core.dynamics;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.auvsim.core.entity.Current;
import org.auvsim.core.field.AiryWave;
import org.auvsim.core.field.OscillatingCurrent;
import org.auvsim.core.field.ShearCurrent;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Vec3;

import java.util.List;
import java.util.OptionalDouble;

/** The water that {@link FossenVehicle} swims in, its formulas written out a second time. */
enum FossenWater {
    /** The same velocity everywhere and always. */
    EVEN {
        @Override
        List<Current> currents() {
            return List.of(new UniformCurrent(1, "stream", new Vec3(0.4, -0.3, 0.1)));
        }

        @Override
        Vector3D velocity(Vector3D place, double t) {
            return new Vector3D(0.4, -0.3, 0.1);
        }

        @Override
        Vector3D byTime(Vector3D place, double t) {
            return Vector3D.ZERO;
        }

        @Override
        Vector3D along(Vector3D place, double t, Vector3D way) {
            return Vector3D.ZERO;
        }
    },

    /** Shear, a tide, and a swell of 8 s that runs along x, over deep water 30 m above. */
    UNEVEN {
        @Override
        List<Current> currents() {
            return List.of(
                    new ShearCurrent(
                            1, "shear", new Vec3(0.4, -0.3, 0), 5, new Vec3(0.02, -0.03, 0)),
                    new OscillatingCurrent(2, "tide", Vec3.ZERO, new Vec3(0.1, 0.2, 0.05), 11, 0.7),
                    new AiryWave(3, "swell", 2, 8, 0, 0.3, OptionalDouble.empty(), SURFACE));
        }

        @Override
        Vector3D velocity(Vector3D p, double t) {
            double e = orbit(p);
            double swing = StrictMath.sin(2 * Math.PI * t / 11 + 0.7);
            return new Vector3D(
                    0.4 + 0.02 * (p.getZ() - 5) + 0.1 * swing + e * StrictMath.cos(theta(p, t)),
                    -0.3 - 0.03 * (p.getZ() - 5) + 0.2 * swing,
                    0.05 * swing + e * StrictMath.sin(theta(p, t)));
        }

        @Override
        Vector3D byTime(Vector3D p, double t) {
            double e = RATE * orbit(p);
            double swing = 2 * Math.PI / 11 * StrictMath.cos(2 * Math.PI * t / 11 + 0.7);
            return new Vector3D(
                    0.1 * swing + e * StrictMath.sin(theta(p, t)),
                    0.2 * swing,
                    0.05 * swing - e * StrictMath.cos(theta(p, t)));
        }

        @Override
        Vector3D along(Vector3D p, double t, Vector3D way) {
            double e = RATE * RATE / 9.80665 * orbit(p);
            double cos = e * StrictMath.cos(theta(p, t));
            double sin = e * StrictMath.sin(theta(p, t));
            return new Vector3D(
                    -sin * way.getX() + (0.02 + cos) * way.getZ(),
                    -0.03 * way.getZ(),
                    cos * way.getX() + sin * way.getZ());
        }

        // The speed at which the swell moves the water.
        private double orbit(Vector3D p) {
            return 2 * RATE * StrictMath.exp(RATE * RATE / 9.80665 * (p.getZ() - SURFACE));
        }

        private double theta(Vector3D p, double t) {
            return RATE * RATE / 9.80665 * p.getX() - RATE * t + 0.3;
        }
    };

    private static final double SURFACE = 30;
    private static final double RATE = 2 * Math.PI / 8;

    /** The same as fields of a world. */
    abstract List<Current> currents();

    /** Velocity (m/s) at a place (m). */
    abstract Vector3D velocity(Vector3D place, double t);

    /** Its derivative by time (m/s^2). */
    abstract Vector3D byTime(Vector3D place, double t);

    /** Its change along a way from the place. */
    abstract Vector3D along(Vector3D place, double t, Vector3D way);
}
