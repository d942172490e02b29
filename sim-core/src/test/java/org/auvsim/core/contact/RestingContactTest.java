package org.auvsim.core.contact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What stands or lies, stepped plainly. */
class RestingContactTest {
    private static final Vec3 UP = new Vec3(0, 0, 1);
    private static final Vec3 HALF = new Vec3(0.5, 0.5, 0.5);

    private static Settling stack(int count, double massOfTop, double dt, ContactSolver solver) {
        Settling stack = new Settling(dt, solver);
        for (int i = 0; i < count; i++) {
            double mass = i == count - 1 ? massOfTop : 1;
            stack.box(new Vec3(0.02 * (i % 2), 0.01 * (i % 3), 0.5 + i), mass, HALF);
        }
        return stack;
    }

    private static void step(Settling stack) {
        stack.step(
                i ->
                        () -> {
                            Settling.Body below = stack.list.get(i - 1);
                            Vec3 n = i == 1 ? UP : below.q.rotate(UP);
                            Vec3 on = i == 1 ? Vec3.ZERO : below.x.plus(n.times(0.5));
                            stack.corners(i, i - 1, on, n);
                        });
    }

    @ParameterizedTest(name = "{0} boxes, the top one of {1} kg, step {2} s")
    @CsvSource({"10, 1, 0.05", "10, 2, 0.05", "10, 20, 0.05", "2, 2, 0.05"})
    void boxesStandForAMinute(int count, double massOfTop, double dt) {
        Settling stack = stack(count, massOfTop, dt, ContactSolver.forResting(1e-6, 400));
        for (int i = 0; i < 60 / dt; i++) {
            step(stack);
        }
        double worst = 0;
        for (int i = 0; i < count; i++) {
            Vec3 there = new Vec3(0.02 * (i % 2), 0.01 * (i % 3), 0.5 + i);
            worst = Math.max(worst, stack.list.get(i + 1).x.minus(there).norm());
        }
        assertThat(worst).isLessThan(1e-3);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = 1)
    void aPileOfTwoHundredBallsComesToRest(long seed) {
        Draws draws = new Draws(seed);
        Settling pile = new Settling(0.01, ContactSolver.forResting(1e-5, 50));
        for (int i = 0; i < 200; i++) {
            Vec3 place = new Vec3(i % 4 - 1.5, i / 4 % 4 - 1.5, 0.6 + Math.floorDiv(i, 16));
            pile.ball(place.plus(draws.vector(0.02)), 1, 0.45);
        }
        boolean rests = false;
        for (int i = 0; i < 2000 && !rests; i++) {
            stepPile(pile);
            rests = pile.contacts.count > 400 && pile.speed() < 1e-3;
        }
        assertThat(rests).isTrue();
    }

    private static void stepPile(Settling pile) {
        pile.step(
                i ->
                        () -> {
                            pile.ballOn(i, 1, Vec3.ZERO, UP);
                            pile.ballOn(i, 2, new Vec3(-2, 0, 0), new Vec3(1, 0, 0));
                            pile.ballOn(i, 3, new Vec3(2, 0, 0), new Vec3(-1, 0, 0));
                            pile.ballOn(i, 4, new Vec3(0, -2, 0), new Vec3(0, 1, 0));
                            pile.ballOn(i, 5, new Vec3(0, 2, 0), new Vec3(0, -1, 0));
                            pile.ballOnBalls(i);
                        });
    }

    /** The slope is gravity that leans. */
    private static Settling slope(double tangent, double friction) {
        Settling slope = new Settling(0.01, ContactSolver.forResting(1e-9, 200));
        double cosine = 1 / Math.sqrt(1 + tangent * tangent);
        slope.gravity = new Vec3(0.6 * tangent, 0.8 * tangent, -1).times(cosine * Settling.GRAVITY);
        slope.friction = friction;
        slope.box(new Vec3(0, 0, 0.2), 3, new Vec3(0.5, 0.4, 0.2));
        return slope;
    }

    @Test
    void aBoxSticksOnASlopeBelowTheAngleOfFriction() {
        Settling slope = slope(0.49, 0.5);
        for (int i = 0; i < 1000; i++) {
            slope.step(a -> () -> slope.corners(a, 0, Vec3.ZERO, UP));
        }
        assertThat(slope.list.get(1).x.minus(new Vec3(0, 0, 0.2)).norm()).isLessThan(1e-6);
    }

    @ParameterizedTest(name = "tangent {0}, friction {1}")
    @CsvSource({"0.55, 0.5", "0.8, 0.3", "0.3, 0"})
    void aBoxSlidesOnASteeperSlopeAsTheClosedFormSays(double tangent, double friction) {
        Settling slope = slope(tangent, friction);
        for (int i = 0; i < 100; i++) {
            slope.step(a -> () -> slope.corners(a, 0, Vec3.ZERO, UP));
        }
        double cosine = 1 / Math.sqrt(1 + tangent * tangent);
        double expected = Settling.GRAVITY * cosine * (tangent - friction);
        Vec3 v = slope.list.get(1).v;
        assertThat(v.x()).isCloseTo(0.6 * expected, within(1e-5));
        assertThat(v.y()).isCloseTo(0.8 * expected, within(1e-5));
    }

    /** Rolls without slipping: 5/7 of the slope's acceleration; needs friction of 2/7 tangent. */
    @Test
    void aBallRollsDownASlope() {
        Settling slope = new Settling(0.01, ContactSolver.forResting(1e-10, 200));
        slope.gravity = new Vec3(2, 0, -9);
        slope.ball(new Vec3(0, 0, 0.3), 2, 0.3);
        for (int i = 0; i < 100; i++) {
            slope.step(a -> () -> slope.ballOn(a, 1, Vec3.ZERO, UP));
        }
        assertThat(slope.list.get(1).v.x()).isCloseTo(2 * 5 / 7.0, within(1e-8));
        assertThat(slope.list.get(1).w.y()).isCloseTo(2 * 5 / 7.0 / 0.3, within(1e-8));
    }
}
