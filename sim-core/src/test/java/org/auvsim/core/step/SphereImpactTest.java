package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import org.assertj.core.data.Offset;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SphereImpactTest {
    private static final double NEVER = Double.POSITIVE_INFINITY;
    private static final int CASES = 2_000;

    private final SphereImpact impact = new SphereImpact();

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4})
    void findsTheRootThatDenseSamplingFinds(long seed) {
        Draws draws = new Draws(seed);
        int contacts = 0;
        for (int i = 0; i < CASES; i++) {
            double scale = StrictMath.pow(10, draws.number(-6, 6));
            double start = scale * draws.number(0.1, 2);
            SphereApproach pair = SphereApproach.drawn(draws, scale * 4, start, start);
            if (pair.gap(0) > 0) contacts += checkAgainstSampling(pair);
        }
        assertThat(contacts).isBetween(CASES / 20, CASES);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {5, 6})
    void findsTheRootOfAReachThatGrows(long seed) {
        Draws draws = new Draws(seed);
        int contacts = 0;
        for (int i = 0; i < CASES; i++) {
            double start = draws.number(0, 1);
            double end = start + draws.number(0, 4);
            SphereApproach pair = SphereApproach.drawn(draws, 5, start, end);
            if (pair.gap(0) > 0) contacts += checkAgainstSampling(pair);
        }
        assertThat(contacts).isGreaterThan(CASES / 10);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {7, 8, 9})
    void findsTheFirstOfSeveralPassesOfAWindingPath(long seed) {
        Draws draws = new Draws(seed);
        int contacts = 0;
        for (int i = 0; i < CASES; i++) {
            Vec3 out = draws.direction().times(draws.number(1.02, 1.2));
            Vec3 back = draws.vector(6);
            SphereApproach pair =
                    new SphereApproach(out, back, back.negated().plus(draws.vector(3)), out, 1, 1);
            contacts += checkAgainstSampling(pair);
        }
        assertThat(contacts).isGreaterThan(CASES / 10);
    }

    /** 1 if there is a contact, 0 otherwise. */
    private int checkAgainstSampling(SphereApproach pair) {
        double expected = pair.firstBySampling(0);
        double found = impact.first(pair.points(), 0, pair.reach0(), pair.reach1());
        if (found != NEVER) {
            assertThat(found).as("%s", pair).isBetween(0.0, 1.0);
            double gap = pair.gap(found);
            assertThat(gap).as("%s", pair).isBetween(-1e-14 * pair.size(), 1e-13 * pair.size());
            assertThat(found).as("%s", pair).isLessThan(expected + 1e-12);
        } else {
            assertThat(expected == NEVER || pair.leastGapAfter(0) > -1e-12 * pair.size())
                    .as("missed: %s", pair)
                    .isTrue();
        }
        if (expected != NEVER && pair.leastGapAfter(0) < -1e-9 * pair.size()) {
            assertThat(found).as("%s", pair).isCloseTo(expected, within(pair, expected));
        }
        return found == NEVER ? 0 : 1;
    }

    /** A root where the gap closes slowly is known less well, by its conditioning. */
    private static Offset<Double> within(SphereApproach pair, double root) {
        double slope = Math.abs(pair.gap(root) - pair.gap(root - 1e-7)) / 1e-7;
        return offset(Math.min(1e-6, 1e-12 + 1e-12 * pair.size() / Math.max(slope, 1e-300)));
    }

    @Test
    void aStraightFlightMeetsWhereTheQuadraticFormulaSays() {
        // Miss distance 0.6 of a reach of 1: contact at x = -0.8 on the way from -3 to 3.
        SphereApproach pair = SphereApproach.straight(new Vec3(-3, 0.6, 0), new Vec3(3, 0.6, 0), 1);
        assertThat(first(pair)).isCloseTo(2.2 / 6, offset(1e-15));
    }

    @Test
    void aGrazeShallowerThanRoundingIsNoContactAndADeeperOneIs() {
        assertThat(first(graze(1))).isEqualTo(NEVER);
        assertThat(first(graze(1 + 1e-15))).isEqualTo(NEVER);
        assertThat(first(graze(1 - 1e-15))).isEqualTo(NEVER);
        double found = first(graze(1 - 1e-10));
        assertThat(found).isLessThan(0.5).isGreaterThan(0.5 - 1e-5);
    }

    private static SphereApproach graze(double miss) {
        return SphereApproach.straight(new Vec3(-4, miss, 0), new Vec3(4, miss, 0), 1);
    }

    @Test
    void aTouchAtTheVeryEndIsLeftToTheNextStep() {
        SphereApproach pair = SphereApproach.straight(new Vec3(3, 0, 0), new Vec3(1, 0, 0), 1);
        assertThat(first(pair)).isEqualTo(NEVER);
        SphereApproach deeper =
                SphereApproach.straight(new Vec3(3, 0, 0), new Vec3(1 - 1e-9, 0, 0), 1);
        assertThat(first(deeper)).isBetween(1 - 1e-9, 1.0);
    }

    @Test
    void aPairThatTouchesAndApproachesMeetsNow() {
        SphereApproach pair = SphereApproach.straight(new Vec3(1, 0, 0), new Vec3(-3, 0, 0), 1);
        assertThat(next(pair)).isZero();
        assertThat(first(pair)).isZero();
    }

    @Test
    void aPairThatTouchesAndPartsDoesNotMeetAgain() {
        for (double rounding : new double[] {-1e-16, 0, 2e-16}) {
            Vec3 start = new Vec3(1 + rounding, 0, 0);
            SphereApproach pair = SphereApproach.straight(start, new Vec3(1.5, 0.3, 0), 1);
            assertThat(next(pair)).isEqualTo(NEVER);
            assertThat(first(pair)).isEqualTo(NEVER);
        }
    }

    @Test
    void anApproachAtRoundingLevelIsNoContact() {
        Vec3 start = new Vec3(1, 0, 0);
        SphereApproach rubbing = SphereApproach.straight(start, new Vec3(1 - 1e-15, 0, 0), 1);
        assertThat(next(rubbing)).isEqualTo(NEVER);
        SphereApproach still = SphereApproach.straight(start, start, 1);
        assertThat(next(still)).isEqualTo(NEVER);
    }

    @Test
    void aPairThatTouchesWithoutSpeedAndIsPulledTogetherMeetsNow() {
        Vec3 start = new Vec3(1, 0, 0);
        Vec3 pulled = new Vec3(1 - 1e-3, 0, 0);
        SphereApproach pair =
                new SphereApproach(start, start, new Vec3(1 - 1e-3 / 3, 0, 0), pulled, 1, 1);
        assertThat(next(pair)).isZero();
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {10, 11, 12})
    void aThrownPairThatTouchesMeetsAgainWhereItFallsBack(long seed) {
        Draws draws = new Draws(seed);
        for (int i = 0; i < CASES; i++) {
            Vec3 start = draws.direction();
            double speed = StrictMath.pow(10, draws.number(-6, 0.5));
            double pull = draws.number(0.1, 10);
            Vec3 aside = start.cross(draws.direction()).times(draws.number(0, speed));
            SphereApproach pair =
                    SphereApproach.thrown(
                            start, start.times(speed).plus(aside), start.times(-pull), 1);
            double least = 1e-3 * speed / pull;
            double expected = pair.firstBySampling(least);
            double found = next(pair);
            if (expected == NEVER) assertThat(pair.leastGapAfter(least)).isGreaterThan(-1e-10);
            if (found == NEVER) assertThat(expected).as("%s", pair).isGreaterThan(1 - 1e-9);
            else {
                assertThat(found).as("%s", pair).isCloseTo(expected, offset(1e-8));
            }
        }
    }

    @Test
    void aWaveThatOutrunsABodyMeetsItInTheMiddle() {
        // Reach 1 + 8 s, body at 5 + 2 s: they meet at s = 2/3.
        SphereApproach pair = SphereApproach.straight(new Vec3(0, 0, 5), new Vec3(0, 0, 7), 1, 9);
        assertThat(first(pair)).isCloseTo(2.0 / 3, offset(1e-15));
    }

    @Test
    void aBulletIsCaughtWithoutOverlap() {
        // 10,000 reaches in the step, and past the middle by half a reach.
        SphereApproach pair =
                SphereApproach.straight(new Vec3(-5000, 0.5, 0), new Vec3(5000, 0.5, 0), 1);
        double found = first(pair);
        assertThat(pair.gap(found)).isBetween(-1e-11, 1e-11);
        assertThat(found).isLessThan(0.5);
    }

    @Test
    void pointsWithoutSizeNeverMeet() {
        SphereApproach pair = SphereApproach.straight(new Vec3(-1, 0, 0), new Vec3(1, 0, 0), 0);
        assertThat(first(pair)).isEqualTo(NEVER);
    }

    private double first(SphereApproach pair) {
        return impact.first(pair.points(), 0, pair.reach0(), pair.reach1());
    }

    private double next(SphereApproach pair) {
        return impact.next(pair.points(), 0, pair.reach0(), pair.reach1());
    }
}
