package org.auvsim.core.dynamics;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.RigidBody;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;

/**
 * Finds what a body's motion got out of all bounds by: at each stage of the Runge-Kutta method from
 * its present state on, what acts on it is evaluated one by one.
 */
public final class Diagnosis {
    private static final double[] NODE = {0, 0.5, 0.5, 1};

    private final EquationsOfMotion equations;
    private final BodyState bodies;
    private final RigidBody body;
    private final Block block = new Block();

    /** Of a body among these. */
    public Diagnosis(EquationsOfMotion equations, BodyState bodies, RigidBody body) {
        this.equations = equations;
        this.bodies = bodies;
        this.body = body;
    }

    /**
     * What acts on the body without bounds in a step of {@code dt} (s), as words for a sentence.
     */
    public String culprit(double time, double dt) {
        equations.load(block, body.slot(), 1, time);
        double[] start = first(block.state);
        for (int stage = 0; stage < NODE.length; stage++) {
            block.time = time + NODE[stage] * dt;
            equations.evaluate(block);
            double[] rates = first(block.rate);
            bodies.applied().write(block);
            if (!isForceFinite()) {
                return "its named forces and propulsors";
            }
            for (Effect effect : body.effects()) {
                if (!isFinite(effect)) {
                    return "its effect '" + kebab(effect.getClass().getSimpleName()) + "'";
                }
            }
            for (int c = 0; stage + 1 < NODE.length && c < BodyState.COLUMNS; c++) {
                block.state[c][0] = start[c] + NODE[stage + 1] * dt * rates[c];
            }
        }
        return "the sum of its forces";
    }

    private static double[] first(double[][] columns) {
        return Arrays.stream(columns).mapToDouble(column -> column[0]).toArray();
    }

    private boolean isFinite(Effect effect) {
        List<List<Effect>> bySlot =
                new ArrayList<>(Collections.nCopies(bodies.count(), List.<Effect>of()));
        bySlot.set(body.slot(), List.of(effect));
        BlockEffect alone = effect.layOut(bySlot);
        for (int c = BodyState.PX; c <= BodyState.LZ; c++) {
            block.rate[c][0] = 0;
        }
        alone.add(block);
        return isForceFinite();
    }

    private boolean isForceFinite() {
        boolean finite = true;
        for (int c = BodyState.PX; c <= BodyState.LZ; c++) {
            finite &= Double.isFinite(block.rate[c][0]);
        }
        return finite;
    }

    private static String kebab(String camel) {
        return camel.replaceAll("(?<=[a-z0-9])(?=[A-Z])", "-").toLowerCase(Locale.ROOT);
    }
}
