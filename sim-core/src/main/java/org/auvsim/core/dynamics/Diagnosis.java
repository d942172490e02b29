package org.auvsim.core.dynamics;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.CoupledEffect;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.RigidBody;
import org.auvsim.core.entity.Surroundings;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/**
 * Finds what a body's motion got out of all bounds by: at each stage of the Runge-Kutta method from
 * its present state on, what acts on it and on all that it is coupled to is evaluated one by one.
 */
public final class Diagnosis {
    private static final double[] NODE = {0, 0.5, 0.5, 1};

    private final EquationsOfMotion equations;
    private final BodyState bodies;
    private final List<? extends RigidBody> bySlot;
    private final RigidBody body;
    private final Surroundings around;
    private final Set<Long> ids = new HashSet<>();

    /** The slots of the body and of all that it is coupled to, itself first. */
    private final int[] together;

    private final Block block;

    /**
     * Of a body.
     *
     * @param bySlot all bodies, the one among them
     * @param around what their effects were laid out with
     */
    public Diagnosis(
            EquationsOfMotion equations,
            BodyState bodies,
            List<? extends RigidBody> bySlot,
            Surroundings around,
            RigidBody body) {
        this.equations = equations;
        this.bodies = bodies;
        this.bySlot = bySlot;
        this.around = around;
        this.body = body;
        bySlot.forEach(other -> ids.add(other.id()));
        int[] companions = equations.groups().companions(body.slot());
        together = new int[companions.length];
        together[0] = body.slot();
        int count = 1;
        for (int slot : companions) {
            if (slot != body.slot()) {
                together[count++] = slot;
            }
        }
        block = new Block(Math.max(Block.SIZE, together.length));
    }

    /**
     * What acts on the body without bounds in a step of {@code dt} (s), as words for a sentence.
     */
    public String culprit(double time, double dt) {
        equations.load(block, together, together.length, time);
        double[][] start = copy(block.state);
        for (int stage = 0; stage < NODE.length; stage++) {
            block.time = time + NODE[stage] * dt;
            equations.evaluate(block);
            double[][] rates = copy(block.rate);
            bodies.applied().write(block);
            if (!areForcesFinite()) {
                return "its named forces and propulsors";
            }
            Optional<String> effect = effect();
            if (effect.isPresent()) {
                return effect.get();
            }
            for (int c = 0; stage + 1 < NODE.length && c < BodyState.COLUMNS; c++) {
                for (int i = 0; i < block.count; i++) {
                    block.state[c][i] = start[c][i] + NODE[stage + 1] * dt * rates[c][i];
                }
            }
        }
        return "the sum of its forces";
    }

    private double[][] copy(double[][] columns) {
        return Arrays.stream(columns)
                .map(column -> Arrays.copyOf(column, block.count))
                .toArray(double[][]::new);
    }

    /** The effect that has no bounds in the block's present state. */
    private Optional<String> effect() {
        for (int slot : together) {
            RigidBody owner = bySlot.get(slot);
            for (Effect effect : owner.effects()) {
                if (isWhole(effect) && !isFinite(effect, slot)) {
                    String name = "effect '" + kebab(effect.getClass().getSimpleName()) + "'";
                    return Optional.of(
                            slot == body.slot()
                                    ? "its " + name
                                    : "the " + name + " of '" + owner.name() + "'");
                }
            }
        }
        return Optional.empty();
    }

    /** A coupled effect ends when one of its partners leaves. */
    private boolean isWhole(Effect effect) {
        return !(effect instanceof CoupledEffect coupled) || ids.containsAll(coupled.partners());
    }

    private boolean isFinite(Effect effect, int owner) {
        List<List<Effect>> alone =
                new ArrayList<>(Collections.nCopies(bodies.count(), List.<Effect>of()));
        alone.set(owner, List.of(effect));
        BlockEffect laidOut = effect.layOut(alone, around);
        for (int c = BodyState.PX; c <= BodyState.LZ; c++) {
            Arrays.fill(block.rate[c], 0, block.count, 0);
        }
        laidOut.add(block);
        return areForcesFinite();
    }

    private boolean areForcesFinite() {
        boolean finite = true;
        for (int c = BodyState.PX; c <= BodyState.LZ; c++) {
            for (int i = 0; i < block.count; i++) {
                finite &= Double.isFinite(block.rate[c][i]);
            }
        }
        return finite;
    }

    private static String kebab(String camel) {
        return camel.replaceAll("(?<=[a-z0-9])(?=[A-Z])", "-").toLowerCase(Locale.ROOT);
    }
}
