package org.auvsim.core.effect;

import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.MagneticField;
import org.auvsim.core.entity.Surroundings;
import org.auvsim.core.math.Vec3;

import java.util.List;

/**
 * A magnet in the body, in the world's magnetic fields B: the torque m x B and the force (m . grad)
 * B (Jackson, Classical Electrodynamics, 1999, section 5.7). It acts at the origin; bodies with
 * dipoles do not see one another.
 *
 * @param moment m (A m^2, body)
 */
public record MagneticDipole(@Unit("A m^2") Vec3 moment) implements Effect {
    /**
     * A checked dipole.
     *
     * @throws IllegalArgumentException if the moment is not finite
     */
    public MagneticDipole {
        Domain.finite("a magnetic dipole", "moment", moment, "A m^2");
    }

    @Override
    public BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        return new MagneticDipoleBlock(bySlot, around.fields(MagneticField.class));
    }
}
