package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.TreeSet;
import java.util.stream.LongStream;

/**
 * The grid tells just the pairs of overlapping boxes, each once, as comparing all with all does.
 */
class ColumnGridTest {
    private static final double EVER = Double.POSITIVE_INFINITY;

    static LongStream seeds() {
        return LongStream.rangeClosed(1, 200);
    }

    /** Small boxes, and among them long, huge, endless and faraway ones. */
    private static void draw(double[] box, int i, SplittableRandom random) {
        int kind = random.nextInt(40);
        double far = kind == 0 ? 1e12 : 1;
        for (int axis = 0; axis < 3; axis++) {
            double middle = far * random.nextDouble(-10, 10);
            double half = random.nextDouble(0, kind == 1 ? 20 : kind == 2 && axis < 2 ? 9 : 0.8);
            box[6 * i + axis] = middle - half;
            box[6 * i + axis + 3] = middle + half;
        }
        if (kind >= 3 && kind < 6) {
            endless(box, i, kind - 3);
        }
    }

    /** What is solid below a plane across an axis; or, if the plane is tilted, has no bounds. */
    private static void endless(double[] box, int i, int axis) {
        for (int k = 0; k < 3; k++) {
            box[6 * i + k] = -EVER;
            if (k != axis) {
                box[6 * i + k + 3] = EVER;
            }
        }
    }

    private static boolean overlap(double[] box, int a, int b) {
        for (int k = 0; k < 3; k++) {
            if (box[6 * a + k] > box[6 * b + k + 3] || box[6 * b + k] > box[6 * a + k + 3]) {
                return false;
            }
        }
        return true;
    }

    private static List<String> allPairs(double[] box, int n) {
        List<String> pairs = new ArrayList<>();
        for (int a = 0; a < n; a++) {
            for (int b = a + 1; b < n; b++) {
                if (overlap(box, a, b)) {
                    pairs.add(a + " " + b);
                }
            }
        }
        return pairs;
    }

    private static List<String> sweep(ColumnGrid grid) {
        List<String> pairs = new ArrayList<>();
        int half = grid.columns() / 2;
        grid.sweep(0, half, (a, b) -> pairs.add(a + " " + b));
        grid.sweep(half, grid.columns(), (a, b) -> pairs.add(a + " " + b));
        grid.sweepLarge((a, b) -> pairs.add(a + " " + b));
        return pairs;
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void tellsEachOverlappingPairOnce(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        int n = random.nextInt(1, 80);
        double[] box = new double[6 * n];
        ColumnGrid grid = new ColumnGrid(box, new int[n], n, Lanes.ONE);

        for (int frame = 0; frame < 3; frame++) {
            for (int i = 0; i < n; i++) {
                draw(box, i, random);
            }
            grid.build();
            assertThat(sweep(grid)).containsExactlyInAnyOrderElementsOf(allPairs(box, n));
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void tellsTheNeighboursOfABoxThatHasChanged(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        int n = random.nextInt(2, 60);
        double[] box = new double[6 * n];
        int[] version = new int[n];
        ColumnGrid grid = new ColumnGrid(box, version, n, Lanes.ONE);
        for (int i = 0; i < n; i++) {
            draw(box, i, random);
        }
        grid.build();
        sweep(grid);

        for (int change = 0; change < 30; change++) {
            int i = random.nextInt(n);
            draw(box, i, random);
            version[i]++;
            grid.changed(i);
            TreeSet<Integer> told = new TreeSet<>();
            grid.pairsOf(i, (a, b) -> told.add(a == i ? b : a));
            TreeSet<Integer> wanted = new TreeSet<>();
            for (int k = 0; k < n; k++) {
                if (k != i && overlap(box, i, k)) {
                    wanted.add(k);
                }
            }
            assertThat(told).as("change %d", change).isEqualTo(wanted);
        }
    }
}
