package org.auvsim.core.dynamics;

import org.auvsim.core.description.ElementName;
import org.auvsim.core.entity.Actuator;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.RigidBody;
import org.auvsim.core.entity.Surroundings;
import org.auvsim.core.entity.Wrench;
import org.auvsim.core.math.Vec3;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Finds what a body's motion got out of all bounds by: at each stage of the Runge-Kutta method from
 * its present state on, what acts on it and on all that it is coupled to is evaluated one by one.
 * What has no bounds itself is named; where all that acts has, the largest of it.
 */
public final class Diagnosis {
    private static final double[] NODE = {0, 0.5, 0.5, 1};

    private final EquationsOfMotion equations;
    private final BodyState bodies;
    private final List<? extends RigidBody> bySlot;
    private final RigidBody body;

    /** The slots of the body and of all that it is coupled to, itself first. */
    private final int[] together;

    private final Block block;
    private final EffectAlone alone;
    private final Largest largest = new Largest();

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
        this.body = body;
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
        alone = new EffectAlone(bySlot, around, block);
    }

    /**
     * What acts on the body without bounds in a step of {@code dt} (s), as words for a sentence.
     */
    public String culprit(double time, double dt) {
        equations.load(block, together, together.length, time);
        noteConstantForces(body);
        double[][] start = copy(block.state);
        for (int stage = 0; stage < NODE.length; stage++) {
            block.time = time + NODE[stage] * dt;
            equations.evaluate(block);
            double[][] rates = copy(block.rate);
            bodies.applied().write(block);
            Optional<String> boundless =
                    alone.areForcesFinite() ? boundless() : Optional.of(constantForce());
            if (boundless.isPresent()) {
                return boundless.get();
            }
            for (int c = 0; stage + 1 < NODE.length && c < BodyState.COLUMNS; c++) {
                for (int i = 0; i < block.count; i++) {
                    block.state[c][i] = start[c][i] + NODE[stage + 1] * dt * rates[c][i];
                }
            }
        }
        return largest.words();
    }

    private double[][] copy(double[][] columns) {
        return Arrays.stream(columns)
                .map(column -> Arrays.copyOf(column, block.count))
                .toArray(double[][]::new);
    }

    /** The effect or actuator that has no bounds in the block's present state; notes the others. */
    private Optional<String> boundless() {
        for (int i = 0; i < together.length; i++) {
            RigidBody owner = bySlot.get(together[i]);
            for (Actuator actuator : owner.actuators()) {
                if (actuator.constantPush().isEmpty()) {
                    alone.evaluate(actuator, i);
                    if (!areFinite(of(owner, actuator))) {
                        return Optional.of(of(owner, actuator));
                    }
                }
            }
            for (Effect effect : owner.effects()) {
                String name = of(owner, "effect", ElementName.of(effect.getClass()));
                if (alone.evaluate(effect, together[i]) && !areFinite(name)) {
                    return Optional.of(name);
                }
            }
        }
        return Optional.empty();
    }

    /** Whether the forces of what has been evaluated are finite; if so, they are noted. */
    private boolean areFinite(String whose) {
        if (alone.areForcesFinite()) {
            largest.note(alone.sizeOnFirst(), whose);
            return true;
        }
        return false;
    }

    /**
     * The largest of the named forces and constant actuators: each is finite, but not their sum.
     */
    private String constantForce() {
        for (int slot : together) {
            noteConstantForces(bySlot.get(slot));
        }
        return largest.words();
    }

    private void noteConstantForces(RigidBody owner) {
        for (NamedForce force : owner.forces()) {
            Vec3 torque = force.point().cross(force.vector());
            largest.note(
                    new Wrench(force.vector(), torque), of(owner, "named force", force.name()));
        }
        for (Actuator actuator : owner.actuators()) {
            actuator.constantPush().ifPresent(push -> largest.note(push, of(owner, actuator)));
        }
    }

    private String of(RigidBody owner, Actuator actuator) {
        return of(owner, ElementName.of(actuator.getClass()), actuator.name());
    }

    private String of(RigidBody owner, String kind, String name) {
        String quoted = kind + " '" + name + "'";
        return owner.id() == body.id()
                ? "its " + quoted
                : "the " + quoted + " of '" + owner.name() + "'";
    }

    /** The largest of what has been noted: by its largest component in N or N m. */
    private static final class Largest {
        private double size;
        private Optional<String> name = Optional.empty();

        void note(Wrench push, String whose) {
            note(Math.max(size(push.force()), size(push.torque())), whose);
        }

        void note(double newSize, String whose) {
            if (newSize > size) {
                size = newSize;
                name = Optional.of(whose);
            }
        }

        private static double size(Vec3 v) {
            return Math.max(Math.abs(v.x()), Math.max(Math.abs(v.y()), Math.abs(v.z())));
        }

        String words() {
            return name.map(it -> it + ", the largest of its forces").orElse("its own speed");
        }
    }
}
