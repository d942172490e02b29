package org.auvsim.diagnosis.genetic;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.math.Vec3;

import java.util.List;
import java.util.Optional;

/**
 * A force (N, world axes) by a formula, to try a proposal out.
 *
 * @param axes the formulas along x, y and z; empty: none acts
 */
record FormulaForce(List<Optional<Formula>> axes) implements BodyEffect {
    @Override
    public void add(Block block, int i) {
        double[] variables = {
            block.time,
            block.state[BodyState.X][i],
            block.state[BodyState.Y][i],
            block.state[BodyState.Z][i],
            block.vx[i],
            block.vy[i],
            block.vz[i],
            StrictMath.atan2(block.rzy[i], block.rzz[i]),
            StrictMath.asin(Math.clamp(-block.rzx[i], -1, 1)),
            StrictMath.atan2(block.ryx[i], block.rxx[i])
        };
        block.addForce(i, new Vec3(along(0, variables), along(1, variables), along(2, variables)));
    }

    private double along(int axis, double[] variables) {
        return axes.get(axis).map(formula -> formula.at(variables)).orElse(0.0);
    }
}
