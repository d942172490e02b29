package org.auvsim.core.effect;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Surroundings;
import org.auvsim.core.math.Vec3;

import java.util.List;

/**
 * The pull of a magnet on a body whose own dipole has turned to it: F = s d / |d|^5 toward a source
 * at the way d, as between two dipoles in line (Griffiths, Introduction to Electrodynamics, 2017,
 * section 6.1.2). Nearer than the closest distance it grows with the way alone, so that it stays
 * finite. It acts at the origin and does not turn the body.
 *
 * @param strength s (N m^4); below 0 it pushes away
 * @param source where the magnet is (m, world)
 * @param closest distance (m) from which on the law holds, above 0
 */
public record MagneticAttraction(
        @Unit("N m^4") @Default("0.0") double strength,
        @Unit("m") @Default("0 0 0") Vec3 source,
        @Unit("m") @Default("0.05") double closest)
        implements Effect {
    /**
     * Checked attraction.
     *
     * @throws IllegalArgumentException if a number is not finite, or the closest distance 0
     */
    public MagneticAttraction {
        Domain.finite("a magnetic attraction", "strength", strength, "N m^4");
        Domain.finite("a magnetic attraction", "source", source, "m");
        Domain.above0("a magnetic attraction", "closest distance", closest, "m");
    }

    @Override
    public boolean dependsOnPlace() {
        return true;
    }

    @Override
    public BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        return OneByOne.stiff(bySlot, (effect, b, i) -> ((MagneticAttraction) effect).add(b, i));
    }

    private void add(Block b, int i) {
        double x = source.x() - b.state[BodyState.X][i];
        double y = source.y() - b.state[BodyState.Y][i];
        double z = source.z() - b.state[BodyState.Z][i];
        double square = Math.max(x * x + y * y + z * z, closest * closest);
        double k = strength / (square * square * Math.sqrt(square));
        b.fx[i] += k * x;
        b.fy[i] += k * y;
        b.fz[i] += k * z;
    }
}
