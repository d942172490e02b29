package org.auvsim.core.field;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Vec3;

/**
 * Water that goes round a vertical axis, the same at any depth. It keeps its volume.
 *
 * @param x of the axis (m, world)
 * @param y of the axis (m, world)
 * @param circulation far from the axis (m^2/s); positive: counter-clockwise, seen from above
 * @param coreRadius of the core (m), above 0
 */
public record VortexCurrent(
        long id,
        String name,
        @Unit("m") @Default("0.0") double x,
        @Unit("m") @Default("0.0") double y,
        @Unit("m^2/s") double circulation,
        @Unit("m") double coreRadius,
        @Default("LAMB_OSEEN") VortexProfile profile)
        implements Current {
    /**
     * A checked current.
     *
     * @throws IllegalArgumentException if a number is not finite, or the core has no radius
     */
    public VortexCurrent {
        String current = "current '" + name + "'";
        Domain.finite(current, "x", x, "m");
        Domain.finite(current, "y", y, "m");
        Domain.finite(current, "circulation", circulation, "m^2/s");
        Domain.above0(current, "core radius", coreRadius, "m");
    }

    @Override
    public Vec3 valueAt(Vec3 position, double time) {
        double rx = position.x() - x;
        double ry = position.y() - y;
        double rate = strength() * profile.rate(rx * rx + ry * ry, coreRadius);
        return new Vec3(-ry * rate, rx * rate, 0);
    }

    private double strength() {
        return circulation / (2 * Math.PI);
    }

    @Override
    public void addTo(Block b) {
        for (int i = 0; i < b.count; i++) {
            addTo(b, i);
        }
    }

    @Override
    public void addTo(Block b, int i) {
        double strength = strength();
        double rx = b.state[BodyState.X][i] - x;
        double ry = b.state[BodyState.Y][i] - y;
        double s = rx * rx + ry * ry;
        double rate = strength * profile.rate(s, coreRadius);
        double change = 2 * strength * profile.change(s, coreRadius);
        b.ux[i] -= ry * rate;
        b.uy[i] += rx * rate;
        b.flow[3][i] -= rx * ry * change;
        b.flow[4][i] -= rate + ry * ry * change;
        b.flow[6][i] += rate + rx * rx * change;
        b.flow[7][i] += rx * ry * change;
    }
}
