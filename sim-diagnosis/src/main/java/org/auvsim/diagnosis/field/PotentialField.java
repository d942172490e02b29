package org.auvsim.diagnosis.field;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.math.Vec3;

import java.util.List;

/**
 * A force (N, world axes) on a body by where it is: the negative slope of a sum of Gaussian
 * potentials.
 *
 * @param centres of the potentials (m, world)
 * @param heights of the potentials (J), one for each centre
 * @param width standard deviation of each (m)
 */
record PotentialField(List<Vec3> centres, List<Double> heights, double width)
        implements BodyEffect {
    /** So many widths away nothing is left of a potential. */
    private static final double FAR = 6;

    @Override
    public void add(Block block, int i) {
        Vec3 place =
                new Vec3(
                        block.state[BodyState.X][i],
                        block.state[BodyState.Y][i],
                        block.state[BodyState.Z][i]);
        block.addForce(i, at(place));
    }

    /** The force at a place. */
    Vec3 at(Vec3 place) {
        double x = 0;
        double y = 0;
        double z = 0;
        for (int c = 0; c < centres.size(); c++) {
            Vec3 off = place.minus(centres.get(c));
            double slope = heights.get(c) * slope(off.norm(), width);
            x += slope * off.x();
            y += slope * off.y();
            z += slope * off.z();
        }
        return new Vec3(x, y, z);
    }

    /** What the force of a potential of height 1 is, over the distance from its centre. */
    private static double slope(double distance, double width) {
        double widths = distance / width;
        return widths > FAR ? 0 : StrictMath.exp(-widths * widths / 2) / (width * width);
    }
}
