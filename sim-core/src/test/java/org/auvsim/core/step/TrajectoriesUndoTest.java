package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.dynamics.EquationsOfMotion;
import org.auvsim.core.dynamics.ImpulseResponse;
import org.auvsim.core.dynamics.Rk4;
import org.auvsim.core.effect.Damping;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Bodies;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;

/** However far a frame has gone, undoing it gives every body its state back to the bit. */
class TrajectoriesUndoTest {
    private static final int COUNT = 150;
    private static final double FRAME = 0.05;

    /** What acts on the bodies, and how stiff it is. */
    record Setting(String name, double damping, Volume volume, List<BlockEffect> bonds) {
        @Override
        public String toString() {
            return name;
        }
    }

    static List<Setting> settings() {
        Volume box = new Box(new Vec3(0.2, 0.3, 0.4));
        List<BlockEffect> bonds = List.of(new Bond(3, 90, 20), new Bond(90, 141, 30));
        return List.of(
                new Setting("balls", 0.1, new Sphere(0.3), List.of()),
                new Setting("boxes that turn", 0.1, box, List.of()),
                new Setting("boxes with stiff forces", 2000, box, List.of()),
                new Setting("boxes coupled to each other", 0.1, box, bonds));
    }

    private Bodies bodies = new Bodies();

    private Trajectories trajectories(Setting setting) {
        Draws draws = new Draws(5);
        bodies = new Bodies();
        for (int slot = 0; slot < COUNT; slot++) {
            WorldObjectDefinition.Builder body =
                    WorldObjectDefinition.named("Body " + slot)
                            .volume(setting.volume())
                            .mass(1)
                            .position(draws.vector(10));
            bodies.add(slot + 1, slot % 10 == 7 ? body.fixed().build() : flying(body, draws));
        }
        Effect damping =
                new Damping(all(setting.damping()), all(0.1), all(setting.damping()), all(0));
        List<BlockEffect> effects =
                new ArrayList<>(
                        List.of(
                                damping.layOut(
                                        Collections.nCopies(COUNT, List.of(damping)),
                                        bodies.surroundings())));
        effects.addAll(setting.bonds());
        return new Trajectories(
                bodies.state(),
                new BodyTraits(bodies.state(), bodies.objects(), new ImpulseResponse(), false),
                new EquationsOfMotion(bodies.state(), effects),
                new Rk4(),
                Lanes.ONE);
    }

    private static WorldObjectDefinition flying(WorldObjectDefinition.Builder body, Draws draws) {
        Vec3 v = draws.vector(3);
        Vec3 w = draws.vector(3);
        return body.velocity(v.x(), v.y(), v.z()).angularVelocity(w.x(), w.y(), w.z()).build();
    }

    private static Vec3 all(double k) {
        return new Vec3(k, k, k);
    }

    /** The bits of all states, by column and slot. */
    private long[][] states() {
        long[][] states = new long[BodyState.COLUMNS][COUNT];
        for (int c = 0; c < states.length; c++) {
            for (int slot = 0; slot < COUNT; slot++) {
                states[c][slot] = Double.doubleToRawLongBits(bodies.state().column(c)[slot]);
            }
        }
        return states;
    }

    /** Moves bodies to an offset, strikes them, and lets them go on. */
    private void collide(Trajectories trajectories, double offset, int... slots) {
        trajectories.moveTo(slots, slots.length, offset);
        for (int slot : slots) {
            bodies.state().column(BodyState.PX)[slot] += 2;
            bodies.state().column(BodyState.LZ)[slot] -= 0.1;
        }
        trajectories.restart(slots, slots.length, offset);
    }

    @ParameterizedTest
    @MethodSource("settings")
    void beforeTheEndIsThePresent(Setting setting) {
        Trajectories trajectories = trajectories(setting);
        long[][] before = states();
        trajectories.begin(0, FRAME);
        collide(trajectories, 0.01, 0, 1, 2, 64, 149);
        collide(trajectories, 0.02, 1, 100);
        assertThat(Arrays.deepEquals(states(), before)).isFalse();

        trajectories.undo();

        assertThat(states()).isDeepEqualTo(before);
    }

    @ParameterizedTest
    @MethodSource("settings")
    void afterTheEndIsThePresent(Setting setting) {
        Trajectories trajectories = trajectories(setting);
        long[][] before = states();
        trajectories.begin(0, FRAME);
        collide(trajectories, 0.01, 0, 1, 2, 64, 149);
        collide(trajectories, 0.02, 1, 100);
        trajectories.commit();
        assertThat(Arrays.deepEquals(states(), before)).isFalse();

        trajectories.undo();

        assertThat(states()).isDeepEqualTo(before);
    }

    @ParameterizedTest
    @MethodSource("settings")
    void afterAnEarlyEnd(Setting setting) {
        Trajectories trajectories = trajectories(setting);
        long[][] before = states();
        trajectories.begin(0, FRAME);
        collide(trajectories, 0.01, 0, 2, 120);
        trajectories.commitAt(0.03);
        assertThat(Arrays.deepEquals(states(), before)).isFalse();

        trajectories.undo();

        assertThat(states()).isDeepEqualTo(before);
    }

    @ParameterizedTest
    @MethodSource("settings")
    void withContactForcesOnBodiesThatHangTogether(Setting setting) {
        Trajectories trajectories = trajectories(setting);
        long[][] before = states();
        int[] island = {10, 11, 12};
        trajectories.begin(0, FRAME);
        trajectories.moveTo(island, island.length, 0.015);
        for (int slot : island) {
            trajectories.forces().set(slot, new double[] {1, 2, 3, 0.1, 0.2, 0.3}, 0);
        }
        trajectories.restartTogether(island, island.length, 0.015, FRAME, new double[18]);
        trajectories.commit();
        assertThat(Arrays.deepEquals(states(), before)).isFalse();

        trajectories.undo();

        assertThat(states()).isDeepEqualTo(before);
    }

    @ParameterizedTest
    @MethodSource("settings")
    void aBodyIsMovedWithAllThatItIsCoupledTo(Setting setting) {
        Trajectories trajectories = trajectories(setting);
        long[][] before = states();
        int[] group = setting.bonds().isEmpty() ? new int[] {90} : new int[] {3, 90, 141};
        trajectories.begin(0, FRAME);
        trajectories.moveTo(90, 0.02);
        trajectories.restart(group, group.length, 0.02);
        long[] x = states()[BodyState.X];
        assertThat(IntStream.range(0, COUNT).filter(slot -> x[slot] != before[BodyState.X][slot]))
                .containsExactlyElementsOf(Arrays.stream(group).boxed().toList());

        trajectories.undo();

        assertThat(states()).isDeepEqualTo(before);
    }

    @Test
    void onlyTheLastFrameIsUndoneAndThenMadeAgain() {
        Trajectories trajectories = trajectories(settings().get(1));
        trajectories.begin(0, FRAME);
        collide(trajectories, 0.01, 0, 1, 2);
        trajectories.commit();
        long[][] between = states();
        trajectories.begin(FRAME, FRAME);
        collide(trajectories, 0.02, 1, 5);
        trajectories.commit();
        long[][] end = states();

        trajectories.undo();
        assertThat(states()).isDeepEqualTo(between);
        trajectories.begin(FRAME, FRAME);
        collide(trajectories, 0.02, 1, 5);
        trajectories.commit();
        assertThat(states()).isDeepEqualTo(end);
    }
}
