package org.auvsim.core.field;

import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Vec3;

/** Water that moves everywhere and always with the same velocity (m/s, world frame). */
public record UniformCurrent(long id, String name, @Unit("m/s") Vec3 velocity) implements Current {
    /**
     * A uniform current.
     *
     * @throws IllegalArgumentException if a component of the velocity is not finite
     */
    public UniformCurrent {
        Domain.finite(Domain.named("current", name), "velocity", velocity, "m/s");
    }

    @Override
    public boolean isUneven() {
        return false;
    }

    @Override
    public void addTo(Block block) {
        for (int i = 0; i < block.count; i++) {
            block.ux[i] += velocity.x();
            block.uy[i] += velocity.y();
            block.uz[i] += velocity.z();
        }
    }

    @Override
    public Vec3 valueAt(Vec3 position, double time) {
        return velocity;
    }
}
