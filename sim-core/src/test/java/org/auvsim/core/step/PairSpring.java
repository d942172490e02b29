package org.auvsim.core.step;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.CoupledEffect;
import org.auvsim.core.math.Vec3;

import java.util.List;

/** A spring of a length (m) between the origins of two bodies, F = k (distance - length). */
record PairSpring(long to, double stiffness, double length) implements CoupledEffect {
    @Override
    public List<Long> partners() {
        return List.of(to);
    }

    @Override
    public void add(Block block, int i, int[] partners) {
        Vec3 way = block.position(partners[0]).minus(block.position(i));
        double distance = way.norm();
        Vec3 force = way.times(stiffness * (distance - length) / distance);
        block.addForce(i, force);
        block.addForce(partners[0], force.times(-1));
    }

    double energy(Vec3 a, Vec3 b) {
        double stretch = a.minus(b).norm() - length;
        return stiffness * stretch * stretch / 2;
    }
}
