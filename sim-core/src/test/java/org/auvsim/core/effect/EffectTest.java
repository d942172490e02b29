package org.auvsim.core.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.dynamics.DrawnBodies;
import org.auvsim.core.dynamics.EquationsOfMotion;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.Bodies;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Gravity and damping, laid out for blocks, against the same effects written body by body. */
class EffectTest {
    private static final Vec3 WATER = new Vec3(0.5, -0.3, 0.2);
    private static final Damping DAMPING =
            new Damping(
                    new Vec3(1, 2, 3), new Vec3(4, 5, 6), new Vec3(7, 8, 9), new Vec3(10, 11, 12));

    /** As the comment of Gravity says it. */
    private record Weight(double g) implements BodyEffect {
        @Override
        public void add(Block block, int i) {
            block.addForce(i, new Vec3(0, 0, -g * block.mass[i]));
        }
    }

    /** As the comment of Damping says it. */
    private record Drag(Damping d) implements BodyEffect {
        @Override
        public void add(Block block, int i) {
            Vec3 v = block.toBody(i, block.velocity(i).minus(block.waterVelocity(i)));
            Vec3 w = block.toBody(i, block.angularVelocity(i));
            block.addForce(i, block.toWorld(i, against(v, d.linear(), d.quadratic())));
            block.addTorque(
                    i, block.toWorld(i, against(w, d.angularLinear(), d.angularQuadratic())));
        }

        private static Vec3 against(Vec3 v, Vec3 a, Vec3 b) {
            return new Vec3(
                    -(a.x() + b.x() * Math.abs(v.x())) * v.x(),
                    -(a.y() + b.y() * Math.abs(v.y())) * v.y(),
                    -(a.z() + b.z() * Math.abs(v.z())) * v.z());
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void gravityIsTheWeight(long seed) {
        assertSame(seed, new Gravity(9.81), new Weight(9.81));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void dampingWorksAgainstTheMotionThroughTheWater(long seed) {
        assertSame(seed, DAMPING, new Drag(DAMPING));
    }

    /** Every third body has none of it, every third one, every third two. */
    private static void assertSame(long seed, Effect forBlocks, Effect forBodies) {
        Block expected = withEffect(seed, forBodies);
        Block actual = withEffect(seed, forBlocks);
        for (int c = BodyState.PX; c <= BodyState.LZ; c++) {
            for (int i = 0; i < actual.count; i += 3) {
                Vec3 got =
                        new Vec3(actual.rate[c][i], actual.rate[c][i + 1], actual.rate[c][i + 2]);
                Vec3 want =
                        new Vec3(
                                expected.rate[c][i],
                                expected.rate[c][i + 1],
                                expected.rate[c][i + 2]);
                assertNear(got, want, 1e-11);
            }
        }
    }

    private static Block withEffect(long seed, Effect effect) {
        Bodies bodies = new Bodies();
        List<List<Effect>> bySlot = new ArrayList<>();
        for (var definition : DrawnBodies.of(seed, 63)) {
            bySlot.add(List.of(effect, effect).subList(0, bodies.count() % 3));
            bodies.add(bodies.count() + 1, definition);
        }
        return evaluated(bodies, effect, bySlot);
    }

    private static Block evaluated(Bodies bodies, Effect effect, List<List<Effect>> bySlot) {
        bodies.state().setFields(List.of(new UniformCurrent(1, "stream", WATER)));
        EquationsOfMotion equations =
                new EquationsOfMotion(
                        bodies.state(), List.of(effect.layOut(bySlot, bodies.surroundings())));
        Block block = new Block();
        equations.load(block, 3, 60, 0);
        equations.evaluate(block);
        return block;
    }

    @Test
    void aBlockWithoutTheEffectIsLeftAsItIs() {
        Block none = new Block();
        none.take(0, 10);
        Arrays.fill(none.vx, 1);
        Arrays.fill(none.rxx, 1);
        List<List<Effect>> bySlot = new ArrayList<>();
        for (int slot = 0; slot < 11; slot++) {
            bySlot.add(slot == 10 ? List.of(DAMPING) : List.of());
        }
        DAMPING.layOut(bySlot, new Bodies().surroundings()).add(none);
        assertThat(none.fx).containsOnly(0);
        none.take(1, 10);
        DAMPING.layOut(bySlot, new Bodies().surroundings()).add(none);
        assertThat(none.fx[9]).isEqualTo(-5);
        assertThat(Arrays.copyOf(none.fx, 9)).containsOnly(0);
    }
}
