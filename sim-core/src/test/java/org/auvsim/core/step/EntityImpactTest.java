package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import org.auvsim.core.entity.Collidable;
import org.auvsim.core.entity.CollisionResponse;
import org.auvsim.core.entity.ExpandingSphere;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.PairQueries;
import org.auvsim.core.volume.Pose;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Optional;

class EntityImpactTest {
    private static final double NEVER = Double.POSITIVE_INFINITY;

    /** The world's time when the curve's clock shows 0. */
    private static final double EPOCH = 100;

    private final PairQueries queries = PairQueries.standard();
    private final EntityImpact impact = new EntityImpact(queries);

    /** A ball of 0.1 m that swings along x by a metre to either side, 5 rad/s fast. */
    private record Pendulum(long id, String name, double bound) implements Collidable {
        @Override
        public Vec3 positionAt(double time) {
            return new Vec3(StrictMath.sin(5 * (time - EPOCH)), 0, 0);
        }

        @Override
        public Volume volumeAt(double time) {
            return new Sphere(0.1);
        }

        @Override
        public double fastestSurface(double from, double to) {
            return bound;
        }

        @Override
        public Optional<CollisionResponse> response() {
            return Optional.empty();
        }
    }

    private static ExpandingSphere wave(double start, double speed, double greatest) {
        return ExpandingSphere.of(1, "Wave", Vec3.ZERO, EPOCH + start, 0.1, speed, greatest);
    }

    private double first(Collidable entity, BodyCurve body, Volume volume) {
        return impact.first(entity, EPOCH, body, volume, 0, 1);
    }

    private static BodyCurve flight(Vec3 from, Vec3 to) {
        return Leg.straight(from, to, Quat.IDENTITY, Vec3.ZERO).curve();
    }

    @Test
    void aFrontMeetsABallThatFleesWhenTheFormulaSays() {
        // 0.1 + 8 (t - 0.25) + 0.5 = 2 + 2 t.
        BodyCurve body = flight(new Vec3(0, 2, 0), new Vec3(0, 4, 0));
        double found = first(wave(0.25, 8, 100), body, new Sphere(0.5));
        assertThat(found).isCloseTo((2 - 0.6 + 2) / 6, offset(1e-14));
    }

    @Test
    void aFrontAsFastAsLightThatHasStoppedShortMeetsNobody() {
        BodyCurve body = flight(new Vec3(300, 0, 0), new Vec3(290, 0, 0));
        ExpandingSphere flash = wave(0, 3e8, 200);

        assertThat(first(flash, body, new Box(new Vec3(1, 1, 1)))).isEqualTo(NEVER);
        assertThat(first(wave(0, 3e8, 295), body, new Box(new Vec3(1, 1, 1))))
                .isCloseTo(0.45, offset(1e-9));
    }

    @Test
    void aFrontThatStopsBeforeABallIsMetByTheBallLater() {
        // It stops with 1 m at 0.1125 s, and the ball of 0.5 m comes from 3 m at 2 m/s.
        BodyCurve body = flight(new Vec3(3, 0, 0), new Vec3(1, 0, 0));
        assertThat(first(wave(0, 8, 1), body, new Sphere(0.5))).isCloseTo(0.75, offset(1e-14));
        assertThat(first(wave(0, 8, 0.4), body, new Sphere(0.5))).isEqualTo(NEVER);
    }

    @Test
    void aWaveThatBeginsAroundABodyMeetsItAtOnce() {
        BodyCurve body = flight(new Vec3(0.3, 0, 0), new Vec3(9, 0, 0));
        assertThat(first(wave(0, 1, 50), body, new Sphere(0.5))).isZero();
        assertThat(first(wave(0, 1, 50), body, new Box(new Vec3(1, 1, 1)))).isZero();
    }

    @Test
    void aFrontMeetsTheFaceOfABox() {
        BodyCurve body = flight(new Vec3(3, 0, 0), new Vec3(2, 0, 0));
        double found = first(wave(0, 3, 50), body, new Box(new Vec3(1, 1, 1)));
        assertThat(found).isCloseTo(2.4 / 4, offset(1e-9));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void noFinerSamplingFindsThatAFrontMetABoxEarlier(long seed) {
        Draws draws = new Draws(seed);
        int contacts = 0;
        for (int i = 0; i < 200; i++) {
            ExpandingSphere wave = wave(draws.number(-0.2, 0.5), draws.number(0.5, 6), 3);
            Box box = new Box(draws.vector(0.1, 2));
            BodyCurve body = Leg.drawn(draws, 4, 2).curve();
            double found = first(wave, body, box);
            contacts += found == NEVER ? 0 : 1;
            for (int k = 0; k < 500 && k / 500.0 < found; k++) {
                assertThat(overlap(wave, body, box, k / 500.0)).isFalse();
            }
            if (found != NEVER) {
                assertThat(found == 0 || gapCloses(wave, body, box, found)).isTrue();
            }
        }
        assertThat(contacts).isBetween(40, 190);
    }

    private boolean gapCloses(ExpandingSphere wave, BodyCurve body, Box box, double t) {
        ExpandingSphere swollen = wave(wave.start() - EPOCH, wave.speed(), wave.greatest() + 1e-9);
        Pose poseOfWave = Pose.of(Vec3.ZERO, Quat.IDENTITY);
        Pose pose = new Pose();
        body.poseAt(t, pose);
        Sphere front = new Sphere(swollen.radiusAt(EPOCH + t) + 1e-9);
        return queries.overlap(front, poseOfWave, box, pose);
    }

    private boolean overlap(Collidable entity, BodyCurve body, Volume volume, double t) {
        Pose pose = new Pose();
        body.poseAt(t, pose);
        Pose there = Pose.of(entity.positionAt(EPOCH + t), entity.orientationAt(EPOCH + t));
        return queries.overlap(entity.volumeAt(EPOCH + t), there, volume, pose);
    }

    @Test
    void withABoundAnEntityThatOnlyBrushesABodyIsNotMissed() {
        // The pendulum turns at x = 1, where it dips 1e-5 m into the ball for 1.8 ms.
        BodyCurve body = Leg.standing(new Vec3(1.6 - 1e-5, 0, 0), Quat.IDENTITY);
        double expected = StrictMath.asin(1 - 1e-5) / 5;
        double found = first(new Pendulum(1, "Pendulum", 5), body, new Sphere(0.5));
        assertThat(found).isCloseTo(expected, offset(1e-6)).isLessThan(expected + 1e-9);
        assertThat(first(new Pendulum(1, "Pendulum", NEVER), body, new Sphere(0.5)))
                .isEqualTo(NEVER);
    }

    @Test
    void withoutABoundTheFirstOverlapThatSamplesShowIsBisected() {
        BodyCurve body = Leg.standing(new Vec3(1.2, 0, 0), Quat.IDENTITY);
        double found = first(new Pendulum(1, "Pendulum", NEVER), body, new Sphere(0.5));
        assertThat(found).isCloseTo(StrictMath.asin(0.6) / 5, offset(1e-14));
    }
}
