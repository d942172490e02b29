package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;

import org.apache.commons.math3.geometry.euclidean.twod.Vector2D;
import org.apache.commons.math3.geometry.euclidean.twod.hull.MonotoneChain;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Manifold;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

class CornersTest {
    private static final Vec3 UP = new Vec3(0, 0, 1);

    private final Corners corners = new Corners();
    private final Manifold manifold = new Manifold();

    private void add(Vec3 point, Vec3 normal) {
        manifold.add(
                point.x(), point.y(), point.z(), normal.x(), normal.y(), normal.z(), /* gap= */ 0);
    }

    private void add(double x, double y) {
        add(new Vec3(x, y, 0), UP);
    }

    private int[] chosen() {
        int[] numbers = Arrays.copyOf(corners.chosen(), corners.choose(manifold));
        Arrays.sort(numbers);
        return numbers;
    }

    @Test
    void fourPointsAreAllKept() {
        add(0, 0);
        add(1, 0);
        add(1, 1);
        add(0, 1);

        assertThat(corners.choose(manifold)).isEqualTo(-1);
    }

    @Test
    void ofARectangleWithMorePointsOnItsEdgesTheCornersStay() {
        add(1, 0);
        add(0, 0);
        add(2, 0);
        add(2, 0.5);
        add(2, 1);
        add(1, 1);
        add(0, 1);
        add(0, 0.5);

        assertThat(chosen()).containsExactly(1, 2, 4, 6);
    }

    @Test
    void ofPointsInALineTheEndsStay() {
        for (int k = 0; k < 6; k++) {
            add(new Vec3(0.1 * k, 0.2 * k, 0), UP);
        }

        assertThat(chosen()).containsExactly(0, 5);
    }

    @Test
    void ofPointsToOneSideOfTheLongestLineThreeStay() {
        add(-1, 0);
        add(1, 0);
        add(-0.5, 0.1);
        add(0, 0.4);
        add(0.5, 0.1);

        assertThat(chosen()).containsExactly(0, 1, 3);
    }

    @Test
    void aContactThatIsNotFlatKeepsAllPoints() {
        for (int k = 0; k < 5; k++) {
            add(new Vec3(k, k * k, 0), UP);
        }
        add(new Vec3(0, 3, 1), new Vec3(1, 0, 0));

        assertThat(corners.choose(manifold)).isEqualTo(-1);
    }

    /** A box's four corners, and a ball that stands out of its bottom between them. */
    @Test
    void whatLiesDeeperThanTheCornersKeepsAllPoints() {
        addCorners();
        manifold.add(0, 0.1, 0, 0, 0, 1, -1e-4);

        assertThat(corners.choose(manifold)).isEqualTo(-1);
    }

    @Test
    void whatIsNoDeeperThanTheCornersIsLeftOut() {
        addCorners();
        manifold.add(0, 0.1, 0, 0, 0, 1, 0);

        assertThat(chosen()).containsExactlyInAnyOrder(0, 1, 2, 3);
    }

    /** The contact of a box that leans a little: its gaps grow along x. */
    private void addCorners() {
        for (Vec3 corner :
                List.of(
                        new Vec3(-1, -1, 0),
                        new Vec3(-1, 1, 0),
                        new Vec3(1, 1, 0),
                        new Vec3(1, -1, 0))) {
            double gap = 1e-5 * corner.x();
            manifold.add(corner.x(), corner.y(), corner.z(), 0, 0, 1, gap);
        }
    }

    /**
     * All points are at most the first two's distance from the first, and no farther aside than the
     * other two: the four hold at least a quarter of the area that all hold.
     */
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
    void theChosenHoldAQuarterOfTheAreaOrMore(long seed) {
        Draws draws = new Draws(seed);
        Quat turn = draws.orientation();
        List<Vector2D> flat = new ArrayList<>();
        for (int k = 0; k < Manifold.MAXIMUM; k++) {
            Vector2D point = new Vector2D(draws.number(-3, 3), draws.number(-1, 1));
            flat.add(point);
            add(turn.rotate(new Vec3(point.getX(), point.getY(), 0.5)), turn.rotate(UP));
        }
        int[] numbers = chosen();

        assertThat(numbers).hasSizeBetween(3, 4).doesNotHaveDuplicates();
        List<Vector2D> kept = Arrays.stream(numbers).mapToObj(flat::get).toList();
        assertThat(area(kept)).isGreaterThanOrEqualTo(area(flat) / 4);
    }

    private static double area(List<Vector2D> points) {
        return new MonotoneChain().generate(points).createRegion().getSize();
    }
}
