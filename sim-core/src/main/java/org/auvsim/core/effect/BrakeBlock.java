package org.auvsim.core.effect;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Effect;
import org.jspecify.annotations.Nullable;

import java.util.List;

/** The brakes of all bodies of a world, at most one a body; most bodies have none. */
final class BrakeBlock implements BlockEffect {
    private final @Nullable Brake[] bySlot;

    BrakeBlock(List<List<Effect>> effects) {
        bySlot = new @Nullable Brake[effects.size()];
        for (int slot = 0; slot < bySlot.length; slot++) {
            for (Effect effect : effects.get(slot)) {
                bySlot[slot] = (Brake) effect;
            }
        }
    }

    @Override
    public void add(Block b) {
        for (int i = 0; i < b.count; i++) {
            Brake brake = bySlot[b.slot(i)];
            if (brake != null) {
                slow(b, i, brake);
                slowTurning(b, i, brake);
            }
        }
    }

    private static void slow(Block b, int i, Brake brake) {
        double x = b.vx[i];
        double y = b.vy[i];
        double z = b.vz[i];
        double k = brake.force() / Math.max(Math.sqrt(x * x + y * y + z * z), brake.slipSpeed());
        b.fx[i] -= k * x;
        b.fy[i] -= k * y;
        b.fz[i] -= k * z;
    }

    private static void slowTurning(Block b, int i, Brake brake) {
        double x = b.rxx[i] * b.wx[i] + b.ryx[i] * b.wy[i] + b.rzx[i] * b.wz[i];
        double y = b.rxy[i] * b.wx[i] + b.ryy[i] * b.wy[i] + b.rzy[i] * b.wz[i];
        double z = b.rxz[i] * b.wx[i] + b.ryz[i] * b.wy[i] + b.rzz[i] * b.wz[i];
        double k = -1 / Math.max(Math.sqrt(x * x + y * y + z * z), brake.slipRate());
        b.addFromBody(
                i,
                0,
                0,
                0,
                k * brake.torque().x() * x,
                k * brake.torque().y() * y,
                k * brake.torque().z() * z);
    }

    /** What does not turn is not turned by it. */
    @Override
    public boolean mayTurn() {
        return false;
    }
}
