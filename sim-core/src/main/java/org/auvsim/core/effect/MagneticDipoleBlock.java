package org.auvsim.core.effect;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.MagneticField;
import org.auvsim.core.math.Vec3;

import java.util.List;

/** The magnetic moments of all bodies of a world (A m^2, body axes); zero for a body without. */
final class MagneticDipoleBlock implements BlockEffect {
    private final Vec3[] moments;
    private final MagneticField[] fields;

    MagneticDipoleBlock(List<List<Effect>> bySlot, List<MagneticField> fields) {
        this.fields = fields.toArray(MagneticField[]::new);
        moments = new Vec3[bySlot.size()];
        for (int slot = 0; slot < moments.length; slot++) {
            Vec3 sum = Vec3.ZERO;
            for (Effect effect : bySlot.get(slot)) {
                sum = sum.plus(((MagneticDipole) effect).moment());
            }
            moments[slot] = sum;
        }
    }

    @Override
    public void add(Block b) {
        for (int i = 0; i < b.count; i++) {
            Vec3 moment = moments[b.slot(i)];
            if (moment.x() != 0 || moment.y() != 0 || moment.z() != 0) {
                add(b, i, b.toWorld(i, moment));
            }
        }
    }

    /** The fields' values and gradients are theirs to work out, place by place. */
    private void add(Block b, int i, Vec3 moment) {
        Vec3 place = b.position(i);
        for (MagneticField field : fields) {
            b.addTorque(i, moment.cross(field.valueAt(place, b.time)));
            b.addForce(i, field.gradientAt(place, b.time).times(moment));
        }
    }
}
