package org.auvsim.core.volume;

import static org.assertj.core.api.Assertions.assertThat;

import org.apache.commons.math3.optim.MaxIter;
import org.apache.commons.math3.optim.linear.LinearConstraint;
import org.apache.commons.math3.optim.linear.LinearConstraintSet;
import org.apache.commons.math3.optim.linear.LinearObjectiveFunction;
import org.apache.commons.math3.optim.linear.NonNegativeConstraint;
import org.apache.commons.math3.optim.linear.Relationship;
import org.apache.commons.math3.optim.linear.SimplexSolver;
import org.apache.commons.math3.optim.nonlinear.scalar.GoalType;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;

/** Against linear programming, which knows nothing of separating axes. */
class BoxBoxOverlapTest {
    private static final Box CUBE = new Box(new Vec3(2, 2, 2));

    private final BoxBox query = new BoxBox();

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void boxesOverlapExactlyIfTheyShareAPoint(long seed) {
        Draws draws = new Draws(seed);
        int overlaps = 0;
        for (int i = 0; i < 100; i++) {
            Box a = new Box(draws.vector(0.2, 2));
            Box b = new Box(draws.vector(0.2, 2));
            Pose poseA = Pose.of(draws.vector(1), draws.orientation());
            Pose poseB = Pose.of(draws.vector(1), draws.orientation());
            double room = roomForABallInBoth(a, poseA, b, poseB);
            if (Math.abs(room) > 1e-6) {
                boolean overlap = query.overlap(a, poseA, b, poseB);
                assertThat(overlap).isEqualTo(room > 0);
                assertThat(query.overlap(b, poseB, a, poseA)).isEqualTo(overlap);
                overlaps += overlap ? 1 : 0;
            }
        }
        assertThat(overlaps).isBetween(20, 80);
    }

    @Test
    void touchingFacesOverlapWhateverTheTurn() {
        for (int seed = 0; seed < 100; seed++) {
            Draws draws = new Draws(seed);
            Quat turn = draws.orientation();
            Pose here = Pose.of(draws.vector(3), turn);
            Vec3 offset = turn.rotate(new Vec3(2, draws.number(-2, 2), draws.number(-2, 2)));
            Pose inside = Pose.of(here.position().plus(offset.times(1 - 1e-12)), turn);
            Pose outside = Pose.of(here.position().plus(offset.times(1 + 1e-9)), turn);
            assertThat(query.overlap(CUBE, here, CUBE, inside)).as("seed %s", seed).isTrue();
            assertThat(query.overlap(CUBE, here, CUBE, outside)).as("seed %s", seed).isFalse();
        }
    }

    @Test
    void crossedEdgesThatOnlyTheirCrossProductSeparatesAreApart() {
        // Two rods, each at 45 degrees to the ground, crossing one above the other.
        Box rod = new Box(new Vec3(10, 1, 1));
        Quat alongX = Quat.ofAxisAngle(new Vec3(1, 0, 0), Math.PI / 4);
        Quat alongY = Quat.ofAxisAngle(new Vec3(0, 0, 1), Math.PI / 2).times(alongX);
        Pose below = Pose.of(Vec3.ZERO, alongX);
        double reach = Math.sqrt(2);
        assertThat(query.overlap(rod, below, rod, Pose.of(new Vec3(0, 0, reach - 1e-9), alongY)))
                .isTrue();
        assertThat(query.overlap(rod, below, rod, Pose.of(new Vec3(0, 0, reach + 1e-9), alongY)))
                .isFalse();
    }

    @Test
    void aSmallBoxDeepInsideALargeOneOverlaps() {
        Box large = new Box(new Vec3(1000, 1000, 10));
        Box small = new Box(new Vec3(0.1, 0.1, 0.1));
        Quat turn = new Draws(1).orientation();
        Pose origin = Pose.of(Vec3.ZERO, turn);
        assertThat(query.overlap(large, origin, small, Pose.of(Vec3.ZERO, turn))).isTrue();
        assertThat(query.overlap(small, origin, large, origin)).isTrue();
    }

    /** The largest s for which a point lies at least s inside all twelve faces. */
    private static double roomForABallInBoth(Box a, Pose poseA, Box b, Pose poseB) {
        List<LinearConstraint> constraints = new ArrayList<>();
        addFaces(constraints, a, poseA);
        addFaces(constraints, b, poseB);
        return new SimplexSolver()
                .optimize(
                        new MaxIter(1000),
                        new LinearObjectiveFunction(new double[] {0, 0, 0, 1}, 0),
                        new LinearConstraintSet(constraints),
                        GoalType.MAXIMIZE,
                        new NonNegativeConstraint(false))
                .getValue();
    }

    private static void addFaces(List<LinearConstraint> constraints, Box box, Pose pose) {
        Vec3[] edges = {
            new Vec3(box.size().x(), 0, 0),
            new Vec3(0, box.size().y(), 0),
            new Vec3(0, 0, box.size().z())
        };
        for (Vec3 edge : edges) {
            for (int sign = -1; sign <= 1; sign += 2) {
                Vec3 n = pose.orientation().rotate(edge.normalized()).times(sign);
                double limit = n.dot(pose.position()) + edge.norm() / 2;
                double[] row = {n.x(), n.y(), n.z(), 1};
                constraints.add(new LinearConstraint(row, Relationship.LEQ, limit));
            }
        }
    }
}
