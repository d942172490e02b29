package org.auvsim.examples.effect;

import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.CoupledEffect;
import org.auvsim.core.math.Vec3;

import java.util.List;

/**
 * An elastic line from its body's origin to that of another one, which pulls both together once it
 * is taut: F = k (distance - length).
 *
 * @param to the id of the other body
 * @param length up to which it is slack (m)
 * @param stiffness k (N/m)
 */
public record TowLine(long to, @Unit("m") double length, @Unit("N/m") double stiffness)
        implements CoupledEffect {
    /**
     * A checked line.
     *
     * @throws IllegalArgumentException if the length or the stiffness is not above 0 and finite
     */
    public TowLine {
        if (!(length > 0 && stiffness > 0) || Double.isInfinite(length + stiffness)) {
            throw new IllegalArgumentException(
                    "a tow line needs a length above 0 m and a stiffness above 0 N/m, but has %s m"
                                    .formatted(length)
                            + " and %s N/m".formatted(stiffness));
        }
    }

    @Override
    public List<Long> partners() {
        return List.of(to);
    }

    @Override
    public void add(Block block, int i, int[] partners) {
        int other = partners[0];
        Vec3 line = block.position(other).minus(block.position(i));
        double distance = line.norm();
        if (distance > length) {
            Vec3 pull = line.times(stiffness * (distance - length) / distance);
            block.addForce(i, pull);
            block.addForce(other, pull.negated());
        }
    }
}
