package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.Capsule;
import org.auvsim.core.volume.HalfSpace;
import org.auvsim.core.volume.PairQueries;
import org.auvsim.core.volume.Pose;
import org.auvsim.core.volume.Separation;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ConservativeAdvancementTest {
    private static final double NEVER = Double.POSITIVE_INFINITY;
    private static final int CASES = 150;
    private static final int SAMPLES = 1_000;

    private final PairQueries queries = PairQueries.standard();
    private final ConservativeAdvancement advancement = new ConservativeAdvancement(queries);
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();
    private final Separation gap = new Separation();

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void noFinerSamplingFindsAnEarlierContact(long seed) {
        Draws draws = new Draws(seed);
        int contacts = 0;
        for (int i = 0; i < CASES; i++) {
            Volume va = drawnVolume(draws);
            Volume vb = drawnVolume(draws);
            double spin = draws.number(0, 2.5);
            BodyCurve a = Leg.drawn(draws, 2.5, spin).curve();
            BodyCurve b = Leg.drawn(draws, 2.5, spin).curve();
            contacts += checkAgainstSampling(a, va, b, vb) ? 1 : 0;
        }
        assertThat(contacts).isBetween(CASES / 10, CASES - CASES / 10);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {7, 8})
    void noFinerSamplingFindsAnEarlierContactWithTheGround(long seed) {
        Draws draws = new Draws(seed);
        int contacts = 0;
        for (int i = 0; i < CASES; i++) {
            BodyCurve a = Leg.drawn(draws, 2.5, 2).curve();
            Vec3 below = draws.vector(0.1).plus(new Vec3(0, 0, -1.5));
            BodyCurve ground = Leg.standing(below, Quat.ofAxisAngle(draws.direction(), 0.5));
            contacts +=
                    checkAgainstSampling(a, drawnVolume(draws), ground, new HalfSpace()) ? 1 : 0;
        }
        assertThat(contacts).isBetween(CASES / 10, CASES - CASES / 10);
    }

    private static Volume drawnVolume(Draws draws) {
        double kind = draws.number(0, 3);
        if (kind < 1) {
            return new Sphere(draws.number(0.1, 1));
        }
        return kind < 2
                ? new Capsule(draws.number(0.05, 0.3), draws.number(0.5, 2))
                : new Box(draws.vector(0.1, 2));
    }

    /** Whether the two come together. */
    private boolean checkAgainstSampling(BodyCurve a, Volume va, BodyCurve b, Volume vb) {
        if (distance(a, va, b, vb, 0) <= 0) {
            return false;
        }
        double smaller = Math.min(va.boundingRadius(), vb.boundingRadius());
        double found = advancement.first(a, va, b, vb, 0, 1);
        if (found != NEVER) {
            assertThat(distance(a, va, b, vb, found)).isBetween(0.0, 1e-10 * smaller);
        }
        for (int i = 1; i <= SAMPLES && (double) i / SAMPLES < found; i++) {
            double t = (double) i / SAMPLES;
            assertThat(distance(a, va, b, vb, t)).as("%s meets %s at %s", va, vb, t).isPositive();
            assertThat(queries.overlap(va, poseA, vb, poseB)).isFalse();
        }
        return found != NEVER;
    }

    private double distance(BodyCurve a, Volume va, BodyCurve b, Volume vb, double t) {
        a.poseAt(t, poseA);
        b.poseAt(t, poseB);
        return queries.distance(va, poseA, vb, poseB, gap);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {9, 10})
    void ballsMeetWhereTheRootOfTheirPolynomialIs(long seed) {
        Draws draws = new Draws(seed);
        SphereImpact exact = new SphereImpact();
        int contacts = 0;
        for (int i = 0; i < 1_000; i++) {
            Sphere va = new Sphere(draws.number(0.1, 1));
            Sphere vb = new Sphere(draws.number(0.1, 1));
            BodyCurve a = Leg.drawn(draws, 3, 2).curve();
            BodyCurve b = Leg.drawn(draws, 3, 2).curve();
            double reach = va.radius() + vb.radius();
            double expected = exact.first(relative(a, b), 0, reach, reach);
            double found = advancement.first(a, va, b, vb, 0, 1);
            if (distance(a, va, b, vb, 0) > 0) {
                if (expected == NEVER) assertThat(found).isEqualTo(NEVER);
                else
                    assertThat(found)
                            .isCloseTo(expected, offset(1e-6))
                            .isLessThan(expected + 1e-14);
                contacts += found == NEVER ? 0 : 1;
            }
        }
        assertThat(contacts).isBetween(100, 900);
    }

    private static double[] relative(BodyCurve a, BodyCurve b) {
        double[] d = new double[12];
        double[] other = new double[12];
        a.pathWithin(0, 1, d, 0);
        b.pathWithin(0, 1, other, 0);
        for (int i = 0; i < 12; i++) {
            d[i] -= other[i];
        }
        return d;
    }

    @Test
    void aRodThatSweepsThroughABallBetweenTheEndsOfTheStepHitsIt() {
        // Half a turn about z: apart from the ball on the y axis at both ends, through it between.
        Box rod = new Box(new Vec3(4, 0.1, 0.1));
        BodyCurve a =
                Leg.straight(Vec3.ZERO, Vec3.ZERO, Quat.IDENTITY, new Vec3(0, 0, Math.PI)).curve();
        Sphere ball = new Sphere(0.05);
        BodyCurve b = Leg.standing(new Vec3(0, 1.9, 0), Quat.IDENTITY);
        assertThat(distance(a, rod, b, ball, 0)).isGreaterThan(1);
        assertThat(distance(a, rod, b, ball, 1)).isGreaterThan(1);
        double found = advancement.first(a, rod, b, ball, 0, 1);
        // The face 0.05 m off the axis meets the ball of 0.05 m at an angle of asin(0.1 / 1.9).
        assertThat(found).isCloseTo(0.5 - 0.0526559 / Math.PI, offset(2e-2));
        assertThat(distance(a, rod, b, ball, found)).isBetween(0.0, 1e-10 * 0.05);
    }

    @Test
    void aBoxThatFallsFlatMeetsTheGroundWhenTheFormulaSays() {
        // 1 m above the ground, from rest, 9.81 m/s^2: half an edge later than its centre would.
        BodyCurve a = fall(new Vec3(0, 0, 1.5), Vec3.ZERO, -9.81);
        BodyCurve ground = Leg.standing(Vec3.ZERO, Quat.IDENTITY);
        double found =
                advancement.first(a, new Box(new Vec3(1, 1, 1)), ground, new HalfSpace(), 0, 1);
        assertThat(found).isCloseTo(Math.sqrt(2 / 9.81), offset(1e-10));
    }

    private static BodyCurve fall(Vec3 from, Vec3 v, double g) {
        Vec3 to = from.plus(v).plus(new Vec3(0, 0, g / 2));
        Vec3 last = v.plus(new Vec3(0, 0, g));
        Leg leg = new Leg(from, v, to, last, Quat.IDENTITY, Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO);
        return leg.curve();
    }

    @Test
    void whatTouchesAndApproachesMeetsNow() {
        BodyCurve ground = Leg.standing(Vec3.ZERO, Quat.IDENTITY);
        Box box = new Box(new Vec3(1, 1, 1));
        for (double gap : new double[] {0, 4e-11, -1e-12}) {
            BodyCurve a = fall(new Vec3(0, 0, 0.5 + gap), new Vec3(2, 0, -1), -9.81);
            assertThat(advancement.first(a, box, ground, new HalfSpace(), 0, 1)).isZero();
        }
    }

    @Test
    void whatTouchesAndLeapsMeetsAgainWhereItComesDown() {
        BodyCurve ground = Leg.standing(Vec3.ZERO, Quat.IDENTITY);
        Box box = new Box(new Vec3(1, 1, 1));
        for (double speed : new double[] {1e-6, 1e-4, 1e-2, 1, 4}) {
            BodyCurve a = fall(new Vec3(0, 0, 0.5), new Vec3(3, 0, speed), -9.81);
            double found = advancement.first(a, box, ground, new HalfSpace(), 0, 1);
            assertThat(found).isCloseTo(2 * speed / 9.81, offset(1e-9 / speed));
        }
    }

    @Test
    void whatTouchesAndPartsForGoodDoesNotMeetAgain() {
        Box box = new Box(new Vec3(1, 1, 1));
        BodyCurve a =
                Leg.straight(Vec3.ZERO, new Vec3(0, 0, 0.3), Quat.IDENTITY, new Vec3(0, 0, 1))
                        .curve();
        BodyCurve b = Leg.standing(new Vec3(0, 0, -1), Quat.IDENTITY);
        assertThat(advancement.first(a, box, b, box, 0, 1)).isEqualTo(NEVER);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {11, 12, 13})
    void whatBouncedOffIsFollowedToItsNextContact(long seed) {
        Draws draws = new Draws(seed);
        for (int i = 0; i < CASES; i++) {
            Volume va = drawnVolume(draws);
            Volume vb = drawnVolume(draws);
            Leg legA = Leg.drawn(draws, 2.5, 2);
            Leg legB = Leg.drawn(draws, 2.5, 2);
            BodyCurve a = legA.curve();
            BodyCurve b = legB.curve();
            double found = advancement.first(a, va, b, vb, 0, 1);
            if (found < 1 && distance(a, va, b, vb, 0) > 0) {
                // Back the way they came: from the very instant, without another contact.
                BodyCurve backA = legA.backward().curve();
                BodyCurve backB = legB.backward().curve();
                double next = advancement.first(backA, va, backB, vb, 1 - found, 1);
                assertThat(next).as("%s and %s", va, vb).isEqualTo(NEVER);
            }
        }
    }
}
