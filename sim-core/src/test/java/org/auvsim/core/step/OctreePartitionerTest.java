package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;

/** The examples of the thesis, section 5.1.2. */
class OctreePartitionerTest {
    private static final double SMALL = 0.01;

    private static WorldObjectDefinition at(double x, double y, double z) {
        return Scene.ball("Grain", SMALL).position(x, y, z).build();
    }

    private static List<List<Integer>> sets(
            OctreePartitioner octree, List<WorldObjectDefinition> objects) {
        CollisionSets sets =
                Scene.partition(
                        Scene.of(objects.toArray(WorldObjectDefinition[]::new)), octree, 0.05);
        List<List<Integer>> found = new ArrayList<>();
        for (int s = 0; s < sets.count(); s++) {
            found.add(Arrays.stream(sets.set(s)).boxed().toList());
        }
        return found;
    }

    @Test
    void pointsInTwoCornersMakeTwoSets() {
        List<WorldObjectDefinition> points =
                List.of(at(2, 1, 0), at(2, 3, 0), at(47, -14, 0), at(48, -12, 0), at(49, -11, 0));

        // They lie in the middle plane of z, so that both halves have them.
        assertThat(new HashSet<>(sets(new OctreePartitioner(6, 3), points)))
                .containsExactlyInAnyOrder(List.of(0, 1), List.of(2, 3, 4));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 5})
    void moreThanFitAtTheCentreEndAtTheGreatestDepthInEightSets(int depth) {
        int perNode = 4;
        List<WorldObjectDefinition> objects = new ArrayList<>();
        for (int i = 0; i <= perNode; i++) {
            objects.add(at(0, 0, 0));
        }
        // Two more, so that the root cube is large and its centre stays.
        objects.add(at(10, 10, 10));
        objects.add(at(-10, -10, -10));

        List<List<Integer>> full =
                sets(new OctreePartitioner(depth, perNode), objects).stream()
                        .filter(set -> set.containsAll(List.of(0, 1, 2, 3, 4)))
                        .toList();

        assertThat(full).hasSize(8);
        if (depth > 1) {
            assertThat(full).allMatch(set -> set.size() == perNode + 1);
        }
    }

    @Test
    void anObjectAtTheCentreIsInAllEight() {
        List<WorldObjectDefinition> objects = new ArrayList<>(List.of(at(0, 0, 0)));
        for (int corner = 0; corner < 8; corner++) {
            objects.add(
                    at(
                            (corner & 1) == 0 ? -5 : 5,
                            (corner & 2) == 0 ? -5 : 5,
                            (corner & 4) == 0 ? -5 : 5));
        }

        List<List<Integer>> sets = sets(new OctreePartitioner(1, 2), objects);

        assertThat(sets).hasSize(8).allMatch(set -> set.size() == 2 && set.contains(0));
    }

    @Test
    void whatFitsInTheRootIsOneSet() {
        assertThat(sets(new OctreePartitioner(6, 2), List.of(at(0, 0, 0), at(9, 9, 9))))
                .containsExactly(List.of(0, 1));
    }

    @Test
    void limitsAreChecked() {
        assertThatThrownBy(() -> new OctreePartitioner(21, 8))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("an octree's maximum depth must be 0 to 20, but is 21");
        assertThatThrownBy(() -> new OctreePartitioner(6, 0))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("must be 1 or more, but is 0");
    }
}
