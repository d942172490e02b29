package org.auvsim.core.field;

import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Numbers;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;

class GriddedCurrentTest {
    private static final double[] X = {-2, -0.5, 1, 4};
    private static final double[] Y = {0, 3};
    private static final double[] Z = {-10, -4, -1};

    /** Trilinear itself, so that interpolation gives it back exactly. */
    private static Vec3 flow(Vec3 p) {
        double x = p.x();
        double y = p.y();
        double z = p.z();
        return new Vec3(
                1 + 2 * x - y + 0.5 * z + 0.3 * x * y - 0.1 * x * y * z,
                x * z - 0.2 * y * z,
                3 - x * y);
    }

    private static GriddedCurrent grid() {
        return new GriddedCurrent(
                1,
                "bay",
                Numbers.of(X),
                Numbers.of(Y),
                Numbers.of(Z),
                values(Vec3::x),
                values(Vec3::y),
                values(Vec3::z));
    }

    private static Numbers values(ToDoubleFunction<Vec3> component) {
        double[] values = new double[X.length * Y.length * Z.length];
        int at = 0;
        for (double z : Z) {
            for (double y : Y) {
                for (double x : X) {
                    values[at++] = component.applyAsDouble(flow(new Vec3(x, y, z)));
                }
            }
        }
        return Numbers.of(values);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void whatIsLinearAlongEachAxisComesBackExactly(long seed) {
        Draws draws = new Draws(seed);
        List<Vec3> places =
                Stream.generate(
                                () ->
                                        new Vec3(
                                                draws.number(-2, 4),
                                                draws.number(0, 3),
                                                draws.number(-10, -1)))
                        .limit(100)
                        .toList();
        for (Vec3 place : places) {
            assertNear(grid().valueAt(place, 0), flow(place), 1e-13);
        }
        Flows.assertExact(grid(), places, 0, 1e-9);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void beyondItsEdgesTheWaterMovesAsAtTheEdge(long seed) {
        Draws draws = new Draws(seed);
        List<Vec3> places = Stream.generate(() -> draws.vector(25)).limit(100).toList();
        for (Vec3 p : places) {
            Vec3 inside =
                    new Vec3(
                            Math.min(4, Math.max(-2, p.x())),
                            Math.min(3, Math.max(0, p.y())),
                            Math.min(-1, Math.max(-10, p.z())));
            assertNear(grid().valueAt(p, 0), flow(inside), 1e-13);
        }
        Flows.assertExact(grid(), places, 0, 1e-8);
    }

    @Test
    void oneLineOfPlacesIsEnough() {
        Numbers one = Numbers.of(0);
        Numbers none = Numbers.of(0, 0);
        GriddedCurrent profile =
                new GriddedCurrent(
                        1,
                        "profile",
                        one,
                        one,
                        Numbers.of(-10, 0),
                        Numbers.of(0.1, 0.5),
                        none,
                        none);
        assertNear(profile.valueAt(new Vec3(77, -3, -5), 0), new Vec3(0.3, 0, 0), 1e-15);
        Flows.assertExact(profile, List.of(new Vec3(1, 2, -3), new Vec3(0, 0, -12)), 0, 1e-10);
    }

    @Test
    void aGridThatIsNoneIsRefused() {
        Numbers one = Numbers.of(0);
        Numbers two = Numbers.of(0, 1);
        assertThatIllegalArgumentException()
                .isThrownBy(
                        () -> new GriddedCurrent(1, "g", Numbers.of(1, 1), one, one, two, two, two))
                .withMessage("the places on x of current 'g' must ascend, but 1.0 m follows 1.0 m");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new GriddedCurrent(1, "g", two, one, one, two, one, two))
                .withMessage(
                        "v of current 'g' must have a number for each of the 2 points (2 x 1 x 1),"
                                + " but has 1");
        assertThatIllegalArgumentException()
                .isThrownBy(
                        () ->
                                new GriddedCurrent(
                                        1, "g", Optional.of("a.csv"), two, one, one, two, two, two))
                .withMessageContaining("either a file or numbers");
        assertThatIllegalArgumentException()
                .isThrownBy(
                        () ->
                                new GriddedCurrent(
                                                1,
                                                "g",
                                                Optional.of("a.csv"),
                                                one,
                                                one,
                                                one,
                                                one,
                                                one,
                                                one)
                                        .prepared())
                .withMessageContaining("current 'g' has not read its file a.csv");
    }
}
