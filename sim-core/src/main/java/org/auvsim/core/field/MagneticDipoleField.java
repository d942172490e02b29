package org.auvsim.core.field;

import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.entity.MagneticField;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;

/**
 * The field of a magnetised ball, such as a wreck or a beacon at a place: outside of it that of a
 * dipole, B = mu0/(4 pi) (3 (m . r) r / r^5 - m / r^3), inside the uniform one of a ball, mu0 m /
 * (2 pi R^3) (Jackson, Classical Electrodynamics, 1999, sections 5.6 and 5.10).
 *
 * @param position of the centre (m, world)
 * @param moment m (A m^2, world)
 * @param radius R of the ball (m), above 0
 */
public record MagneticDipoleField(
        long id,
        String name,
        @Unit("m") Vec3 position,
        @Unit("A m^2") Vec3 moment,
        @Unit("m") double radius)
        implements MagneticField {
    /** mu0 / (4 pi) (T m/A): 1e-7 to ten digits (CODATA 2018). */
    private static final double CONSTANT = 1e-7;

    /**
     * A checked field.
     *
     * @throws IllegalArgumentException if a number is not finite, or the ball has no radius
     */
    public MagneticDipoleField {
        String field = "magnetic field '" + name + "'";
        Domain.finite(field, "position", position, "m");
        Domain.finite(field, "moment", moment, "A m^2");
        Domain.above0(field, "radius", radius, "m");
    }

    @Override
    public Vec3 valueAt(Vec3 place, double time) {
        Vec3 r = place.minus(position);
        double d = Math.max(radius, r.norm());
        double k = CONSTANT / (d * d * d);
        boolean isInside = r.norm() < radius;
        double along = isInside ? 0 : 3 * k * moment.dot(r) / (d * d);
        return r.times(along).plus(moment.times(isInside ? 2 * k : -k));
    }

    /** 3 mu0/(4 pi r^4) (m n^T + n m^T + (m . n) (1 - 5 n n^T)) with n = r / |r|; zero inside. */
    @Override
    public Mat3 gradientAt(Vec3 place, double time) {
        Vec3 r = place.minus(position);
        double d = Math.max(radius, r.norm());
        Vec3 n = r.times(1 / d);
        double along = moment.dot(n);
        double k = r.norm() < radius ? 0 : 3 * CONSTANT / (d * d * d * d);
        Vec3 x = row(n, n.x(), moment.x(), along, k);
        Vec3 y = row(n, n.y(), moment.y(), along, k);
        Vec3 z = row(n, n.z(), moment.z(), along, k);
        return new Mat3(
                x.x() + k * along,
                x.y(),
                x.z(),
                y.x(),
                y.y() + k * along,
                y.z(),
                z.x(),
                z.y(),
                z.z() + k * along);
    }

    /** One row without its part of the identity: k (m_i n + n_i m - 5 (m . n) n_i n). */
    private Vec3 row(Vec3 n, double ni, double mi, double along, double k) {
        return n.times(k * (mi - 5 * along * ni)).plus(moment.times(k * ni));
    }
}
