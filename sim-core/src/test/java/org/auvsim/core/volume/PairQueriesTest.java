package org.auvsim.core.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Numbers;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;

import java.util.List;

class PairQueriesTest {
    private static final Sphere SPHERE = new Sphere(1);
    private static final Box BOX = new Box(new Vec3(2, 2, 2));
    private static final Pose ORIGIN = new Pose();
    private static final Pose ABOVE = Pose.of(new Vec3(0, 0, 1.5), Quat.IDENTITY);

    private final PairQueries queries = PairQueries.standard();

    /** A user's own volume: the half of space below z = 0. */
    private record Seabed() implements Volume {
        @Override
        public double boundingRadius() {
            return Double.POSITIVE_INFINITY;
        }

        @Override
        public Mat3 inertia(double mass) {
            return Mat3.IDENTITY;
        }

        @Override
        public boolean contains(Vec3 point) {
            return point.z() <= 0;
        }
    }

    private static final class SphereSeabed implements PairQuery<Sphere, Seabed> {
        @Override
        public boolean overlap(Sphere a, Pose poseA, Seabed b, Pose poseB) {
            return poseA.z - poseB.z <= a.radius();
        }

        @Override
        public ContactPoint contact(Sphere a, Pose poseA, Seabed b, Pose poseB) {
            double depth = a.radius() - (poseA.z - poseB.z);
            return new ContactPoint(new Vec3(poseA.x, poseA.y, poseB.z), new Vec3(0, 0, 1), depth);
        }
    }

    @Test
    void theOrderOfTheTwoDoesNotMatter() {
        PairQueries queries = PairQueries.standard();
        ContactPoint one = queries.contact(SPHERE, ABOVE, BOX, ORIGIN);
        assertThat(one.normal()).isEqualTo(new Vec3(0, 0, 1));
        assertThat(queries.contact(BOX, ORIGIN, SPHERE, ABOVE)).isEqualTo(one.flipped());
        assertThat(queries.overlap(SPHERE, ABOVE, BOX, ORIGIN)).isTrue();
        assertThat(queries.overlap(BOX, ORIGIN, SPHERE, ABOVE)).isTrue();
    }

    @Test
    void everyPairOfStandardVolumesIsKnown() {
        Volume[] volumes = {
            SPHERE,
            BOX,
            new Capsule(1, 1),
            new Compound(List.of(new Part(BOX, Vec3.ZERO, Quat.IDENTITY)))
        };
        for (Volume a : volumes) {
            for (Volume b : volumes) {
                assertThat(PairQueries.standard().overlap(a, ABOVE, b, ORIGIN)).isTrue();
                assertThat(PairQueries.standard().contact(a, ABOVE, b, ORIGIN).depth())
                        .isPositive();
            }
        }
    }

    @Test
    void whatGoesOnForEverMeetsOnlyWhatIsBounded() {
        HeightMap floor =
                new HeightMap(
                        1,
                        List.of(
                                new HeightMap.Row(Numbers.of(0, 0)),
                                new HeightMap.Row(Numbers.of(0, 0))));
        Volume half = new HalfSpace();
        assertThatExceptionOfType(UnsupportedOperationException.class)
                .isThrownBy(() -> queries.distance(half, ORIGIN, floor, ORIGIN, new Separation()))
                .withMessage(
                        "a HalfSpace and a HeightMap never meet: both go on for ever; make the"
                                + " objects fixed");
        assertThat(queries.overlap(floor, ORIGIN, BOX, ABOVE)).isFalse();
        assertThat(queries.contact(half, ORIGIN, BOX, ABOVE).depth()).isEqualTo(-0.5);
    }

    @Test
    void distanceAndManifoldOfAUsersOwnQueryFollowFromItsContact() {
        PairQueries more = queries.with(Sphere.class, Seabed.class, new SphereSeabed());
        Separation found = new Separation();
        assertThat(more.distance(new Seabed(), ORIGIN, SPHERE, ABOVE, found)).isEqualTo(0.5);
        assertThat(found.nz).isEqualTo(-1);
        Manifold manifold = new Manifold();
        more.manifold(SPHERE, ABOVE, new Seabed(), ORIGIN, 0.4, manifold);
        assertThat(manifold.count).isZero();
        more.manifold(SPHERE, ABOVE, new Seabed(), ORIGIN, 0.6, manifold);
        assertThat(manifold.count).isEqualTo(1);
        assertThat(manifold.gap[0]).isEqualTo(0.5);
        assertThat(manifold.nz[0]).isEqualTo(1);
    }

    @Test
    void anUnknownPairSaysSo() {
        assertThatExceptionOfType(UnsupportedOperationException.class)
                .isThrownBy(() -> PairQueries.standard().overlap(BOX, ORIGIN, new Seabed(), ORIGIN))
                .withMessage(
                        "no pair query knows how a Box meets a Seabed; register one with"
                                + " PairQueries.with");
        assertThatExceptionOfType(UnsupportedOperationException.class)
                .isThrownBy(
                        () -> PairQueries.standard().contact(BOX, ORIGIN, new Seabed(), ORIGIN));
    }

    @Test
    void aUsersOwnQueryIsFoundInEitherOrder() {
        PairQueries queries =
                PairQueries.standard().with(Sphere.class, Seabed.class, new SphereSeabed());
        Pose sunk = Pose.of(new Vec3(1, 2, 0.75), Quat.IDENTITY);
        assertThat(queries.overlap(SPHERE, sunk, new Seabed(), ORIGIN)).isTrue();
        assertThat(queries.overlap(new Seabed(), ORIGIN, SPHERE, ABOVE)).isFalse();
        ContactPoint contact = queries.contact(new Seabed(), ORIGIN, SPHERE, sunk);
        assertThat(contact)
                .isEqualTo(new ContactPoint(new Vec3(1, 2, 0), new Vec3(-0.0, -0.0, -1), 0.25));
        assertThat(queries.overlap(SPHERE, ABOVE, BOX, ORIGIN)).isTrue();
    }
}
