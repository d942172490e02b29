package org.auvsim.core.volume;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;

class ReachTest {
    private static double reach(Volume volume, Pose pose, Vec3 n) {
        return volume.reach(pose, n.x(), n.y(), n.z());
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void noPointOfAVolumeLiesBeyondItsReachAndOneComesNear(long seed) {
        Draws draws = new Draws(seed);
        List<Volume> volumes =
                List.of(
                        new Sphere(draws.number(0.1, 1)),
                        new Box(draws.vector(0.1, 2)),
                        new Capsule(draws.number(0.1, 1), draws.number(0.1, 2)));
        for (Volume volume : volumes) {
            Pose pose = Pose.of(draws.vector(9), draws.orientation());
            Vec3 n = draws.direction();
            double reach = reach(volume, pose, n);
            double farthest = 0;
            for (int i = 0; i < 20_000; i++) {
                Vec3 point = surface(volume, draws.direction());
                farthest = Math.max(farthest, n.dot(pose.orientation().rotate(point)));
            }
            assertThat(farthest).isBetween(0.95 * reach, reach * (1 + 1e-12));
        }
    }

    /** The point in a direction (body) that is still inside. */
    private static Vec3 surface(Volume volume, Vec3 direction) {
        double inside = 0;
        double outside = volume.boundingRadius() * 1.001;
        for (int i = 0; i < 50; i++) {
            double middle = (inside + outside) / 2;
            if (volume.contains(direction.times(middle))) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        return direction.times(inside);
    }

    @Test
    void aHalfSpaceReachesItsPlaneAlongItsNormalAndForEverOtherwise() {
        Pose pose = Pose.of(new Vec3(1, 2, 3), Quat.ofAxisAngle(new Vec3(1, 2, 0), 0.7));
        HalfSpace ground = new HalfSpace();
        Vec3 normal = pose.orientation().rotate(new Vec3(0, 0, 1));
        assertThat(reach(ground, pose, normal)).isZero();
        assertThat(reach(ground, pose, normal.negated())).isInfinite();
        assertThat(reach(ground, pose, new Vec3(0, 0, 1))).isInfinite();
    }

    @Test
    void aVolumeThatDoesNotTellReachesItsBoundingRadius() {
        Volume volume = new Sphere(2);
        assertThat(reach(volume, new Pose(), new Vec3(0, 1, 0))).isEqualTo(2);
    }
}
