package org.auvsim.core.field;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Vec3;

/**
 * Water whose velocity changes evenly with height: u = velocity + shear (z - height).
 *
 * @param velocity at {@code height} (m/s)
 * @param height where the velocity is stated (m, world)
 * @param shear change of the velocity by metre of height (1/s), horizontal, as water keeps its
 *     volume
 */
public record ShearCurrent(
        long id,
        String name,
        @Unit("m/s") Vec3 velocity,
        @Unit("m") @Default("0.0") double height,
        @Unit("1/s") Vec3 shear)
        implements Current {
    /**
     * A checked current.
     *
     * @throws IllegalArgumentException if a number is not finite, or the shear has a vertical part
     */
    public ShearCurrent {
        String current = "current '" + name + "'";
        Domain.finite(current, "velocity", velocity, "m/s");
        Domain.finite(current, "height", height, "m");
        Domain.finite(current, "shear", shear, "1/s");
        if (shear.z() != 0) {
            throw new IllegalArgumentException(
                    "the shear of %s must be horizontal, as water keeps its volume, but is %s 1/s"
                            .formatted(current, shear));
        }
    }

    @Override
    public Vec3 valueAt(Vec3 position, double time) {
        return velocity.plus(shear.times(position.z() - height));
    }

    @Override
    public void addTo(Block b) {
        for (int i = 0; i < b.count; i++) {
            addTo(b, i);
        }
    }

    @Override
    public void addTo(Block b, int i) {
        double above = b.state[BodyState.Z][i] - height;
        b.ux[i] += velocity.x() + shear.x() * above;
        b.uy[i] += velocity.y() + shear.y() * above;
        b.uz[i] += velocity.z();
        b.flow[5][i] += shear.x();
        b.flow[8][i] += shear.y();
    }
}
