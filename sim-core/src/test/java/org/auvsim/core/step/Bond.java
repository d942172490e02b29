package org.auvsim.core.step;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.math.Vec3;

import java.util.List;

/** A spring of no length and a stiffness (N/m) between the bodies of two slots. */
record Bond(int first, int second, double stiffness) implements BlockEffect {
    @Override
    public void add(Block block) {
        int a = block.indexOf(first);
        int b = block.indexOf(second);
        if (a >= 0 && b >= 0) {
            Vec3 way = block.position(b).minus(block.position(a));
            block.addForce(a, way.times(stiffness));
            block.addForce(b, way.times(-stiffness));
        }
    }

    @Override
    public List<int[]> couples() {
        return List.of(new int[] {first, second});
    }
}
