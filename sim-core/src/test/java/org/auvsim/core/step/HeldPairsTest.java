package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.dynamics.EquationsOfMotion;
import org.auvsim.core.dynamics.ImpulseResponse;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Bodies;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;

class HeldPairsTest {
    private static final int FLOOR = 6;

    private final HeldPairs pairs = sevenBodies();

    /** Six bodies that can move, and a seventh that is fixed. */
    private static HeldPairs sevenBodies(BlockEffect... effects) {
        return pairs(FLOOR, 1, effects);
    }

    private static HeldPairs pairs(int moving, int fixed, BlockEffect... effects) {
        Bodies bodies = new Bodies();
        for (int slot = 0; slot < moving + fixed; slot++) {
            WorldObjectDefinition.Builder ball = Scene.ball("Ball " + slot, 0.5);
            bodies.add(slot + 1, (slot < moving ? ball : ball.fixed()).build());
        }
        BodyTraits traits =
                new BodyTraits(bodies.state(), bodies.objects(), new ImpulseResponse(), false);
        return new HeldPairs(
                traits, new EquationsOfMotion(bodies.state(), List.of(effects)).groups());
    }

    private void hold(int first, int second) {
        pairs.hold(first, second, 0, 0);
    }

    private static int[] members(HeldPairs of) {
        return Arrays.copyOf(of.members(), of.memberCount());
    }

    private static int[] islandPairs(HeldPairs of) {
        return Arrays.copyOf(of.pairs(), of.pairCount());
    }

    @Test
    void anIslandIsAllThatHeldPairsLeadTo() {
        hold(3, 4);
        hold(1, 2);
        hold(2, 0);

        pairs.findIsland(1, 1);
        assertThat(members(pairs)).containsExactly(0, 1, 2);
        assertThat(islandPairs(pairs)).containsExactly(1, 2);

        pairs.findIsland(4, 4);
        assertThat(members(pairs)).containsExactly(3, 4);
        assertThat(islandPairs(pairs)).containsExactly(0);
    }

    @Test
    void twoThatHangFreeAreAnIslandOfTheirOwn() {
        hold(1, 2);

        pairs.findIsland(5, 3);

        assertThat(members(pairs)).containsExactly(3, 5);
        assertThat(islandPairs(pairs)).isEmpty();
    }

    @Test
    void fixedBodiesJoinNothing() {
        hold(0, FLOOR);
        hold(1, FLOOR);

        pairs.findIsland(1, FLOOR);

        assertThat(members(pairs)).containsExactly(1);
        assertThat(islandPairs(pairs)).containsExactly(1);
    }

    @Test
    void aReleasedPairLeadsNowhere() {
        hold(0, 1);
        hold(1, 2);

        pairs.release(0);

        assertThat(pairs.isHeld(0, 1)).isFalse();
        assertThat(pairs.isHeld(0)).isFalse();
        assertThat(pairs.holds(0)).isFalse();
        assertThat(pairs.holds(1)).isTrue();
        pairs.findIsland(1, 1);
        assertThat(members(pairs)).containsExactly(1, 2);
        assertThat(islandPairs(pairs)).containsExactly(1);
    }

    @Test
    void aReleasedPairIsHeldAgainInItsOldPlace() {
        pairs.hold(0, 1, 0.5, 2);
        hold(1, 2);
        pairs.release(0);

        pairs.hold(1, 0, 0.25, 3);

        assertThat(pairs.count()).isEqualTo(2);
        assertThat(pairs.isHeld(0)).isTrue();
        assertThat(pairs.reach(0)).isEqualTo(0.25);
        assertThat(pairs.limit(0)).isEqualTo(3);
        pairs.findIsland(2, 2);
        assertThat(members(pairs)).containsExactly(0, 1, 2);
    }

    @Test
    void aPairIsHeldWhicheverIsNamedFirst() {
        hold(2, 5);
        hold(FLOOR, 4);

        assertThat(pairs.isHeld(5, 2)).isTrue();
        assertThat(pairs.isHeld(4, FLOOR)).isTrue();
        assertThat(pairs.isHeld(FLOOR, 4)).isTrue();
        assertThat(pairs.isHeld(2, FLOOR)).isFalse();
        assertThat(pairs.isHeld(2, 4)).isFalse();
    }

    @Test
    void groupsComeAlongSideBySide() {
        HeldPairs coupled = sevenBodies(new Bond(0, 4, 1), new Bond(4, FLOOR, 1));
        coupled.hold(4, 2, 0, 0);
        coupled.hold(2, 1, 0, 0);

        coupled.findIsland(1, 1);
        assertThat(members(coupled)).containsExactly(0, 4, 1, 2);
        assertThat(islandPairs(coupled)).containsExactly(0, 1);

        coupled.findIsland(0, 0);
        assertThat(members(coupled)).containsExactly(0, 4, 1, 2);
        coupled.findIsland(3, 3);
        assertThat(members(coupled)).containsExactly(3);
    }

    @Test
    void aReleasedPairDoesNotPartAGroup() {
        HeldPairs coupled = sevenBodies(new Bond(1, 3, 1));
        coupled.hold(1, 3, 0, 0);
        coupled.release(0);

        coupled.findIsland(3, 3);

        assertThat(members(coupled)).containsExactly(1, 3);
        assertThat(islandPairs(coupled)).isEmpty();
    }

    @Test
    void nothingIsLeftWhenAllIsForgotten() {
        hold(0, 1);
        hold(2, FLOOR);

        pairs.clear();

        assertThat(pairs.isEmpty()).isTrue();
        assertThat(pairs.holds(0)).isFalse();
        assertThat(pairs.isHeld(2, FLOOR)).isFalse();
        hold(1, 2);
        pairs.findIsland(1, 1);
        assertThat(members(pairs)).containsExactly(1, 2);
        assertThat(islandPairs(pairs)).containsExactly(0);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void islandsAreTheConnectedParts(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        int moving = 200;
        int all = moving + 5;
        HeldPairs many = pairs(moving, all - moving);
        boolean[][] joins = new boolean[all][all];
        for (int k = 0; k < 170; k++) {
            int a = random.nextInt(moving);
            int b = random.nextInt(all);
            if (a != b) {
                many.hold(a, b, 0, 0);
                joins[a][b] = b < moving;
                joins[b][a] = b < moving;
            }
        }
        for (int k = 0; k < many.count(); k += 9) {
            many.release(k);
            joins[many.first(k)][many.second(k)] = false;
            joins[many.second(k)][many.first(k)] = false;
        }

        for (int body = 0; body < moving; body++) {
            BitSet reached = reached(joins, body);
            many.findIsland(body, body);
            assertThat(members(many)).containsExactly(reached.stream().toArray());
            int[] wanted =
                    IntStream.range(0, many.count())
                            .filter(many::isHeld)
                            .filter(k -> reached.get(many.first(k)) || reached.get(many.second(k)))
                            .toArray();
            assertThat(islandPairs(many)).containsExactly(wanted);
        }
    }

    /** All that a body is joined to, found by looking again until nothing is new. */
    private static BitSet reached(boolean[][] joins, int body) {
        BitSet reached = new BitSet();
        reached.set(body);
        int before = 0;
        while (reached.cardinality() > before) {
            before = reached.cardinality();
            for (int a = 0; a < joins.length; a++) {
                for (int b = 0; reached.get(a) && b < joins.length; b++) {
                    reached.set(b, reached.get(b) || joins[a][b]);
                }
            }
        }
        return reached;
    }
}
