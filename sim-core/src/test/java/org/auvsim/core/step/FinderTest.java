package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.ContactPoint;
import org.auvsim.core.volume.PairQueries;
import org.auvsim.core.volume.PairQuery;
import org.auvsim.core.volume.Pose;
import org.auvsim.core.volume.Sphere;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;

class FinderTest {
    /** Answers as the standard query does, and counts how often it is asked for overlap. */
    private static final class Counting implements PairQuery<Sphere, Sphere> {
        private int overlaps;

        @Override
        public boolean overlap(Sphere a, Pose poseA, Sphere b, Pose poseB) {
            overlaps++;
            return PairQueries.standard().overlap(a, poseA, b, poseB);
        }

        @Override
        public ContactPoint contact(Sphere a, Pose poseA, Sphere b, Pose poseB) {
            return PairQueries.standard().contact(a, poseA, b, poseB);
        }
    }

    private static double find(CollisionFinder finder, Motion motion, double dt) {
        return finder.earliest(motion, Scene.partition(motion, new AllPairsPartitioner(), dt), dt);
    }

    /** A ball that flies at a fixed one; their surfaces are 0.7 m apart. */
    private static List<WorldObjectDefinition> approach() {
        return List.of(
                Scene.ball("A", 0.5).velocity(1, 0, 0).build(),
                Scene.ball("B", 0.5).position(1.7, 0, 0).fixed().build());
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5, 30})
    void bisectionReturnsTheUpperEndAfterExactlyTheMaximumOfIterations(int iterations) {
        Counting query = new Counting();
        Motion motion =
                Scene.of(
                        PairQueries.standard().with(Sphere.class, Sphere.class, query), approach());

        double found = find(new BisectionFinder(2, iterations), motion, 1);

        // Apart at 0 and 1/2, overlapping at 1; then the halves of [1/2, 1].
        double width = StrictMath.pow(0.5, iterations + 1);
        assertThat(found).isEqualTo(width * StrictMath.ceil(0.7 / width));
        assertThat(query.overlaps).isEqualTo(3 + iterations);
    }

    @Test
    void aPairThatOverlapsAndApproachesCollidesAtOnce() {
        assertThat(find(BisectionFinder.standard(), overlapping(-1), 0.05)).isZero();
    }

    @Test
    void aPairThatOverlapsAndPartsIsLeftAlone() {
        assertThat(find(BisectionFinder.standard(), overlapping(1), 0.05)).isInfinite();
        assertThat(find(BisectionFinder.standard(), overlapping(0), 0.05)).isInfinite();
    }

    private static Motion overlapping(double partingSpeed) {
        return Scene.of(
                Scene.ball("A", 0.5).position(0.9, 0, 0).velocity(partingSpeed, 0, 0).build(),
                Scene.ball("B", 0.5).fixed().build());
    }

    @Test
    void theSearchBeginsAgainWhenTheTwoAreApart() {
        // distance = 0.95 + 2 t - 2.1 t^2: above 1 from 0.0257 s on, below again from 0.92669 s on.
        NamedForce back = NamedForce.direct("Back", Frame.WORLD, new Vec3(-4.2, 0, 0));
        Motion motion =
                Scene.of(
                        Scene.ball("A", 0.5)
                                .position(0.95, 0, 0)
                                .velocity(2, 0, 0)
                                .force(back)
                                .build(),
                        Scene.ball("B", 0.5).fixed().build());

        double again = (2 + Math.sqrt(4 - 4 * 2.1 * 0.05)) / 4.2;
        assertThat(find(new BisectionFinder(10, 50), motion, 1)).isEqualTo(again, within(1e-12));
    }

    /** The thesis' search samples: what begins and ends between two instants, it does not see. */
    @Test
    void aGrazingContactIsMissedUpToOnePercentOfTheRadius() {
        assertThat(find(BisectionFinder.standard(), passing(0.0049), 0.1)).isInfinite();
        assertThat(find(BisectionFinder.standard(), passing(0.0051), 0.1)).isLessThan(0.1);
        assertThat(find(new BisectionFinder(7, 32), passing(0.0049), 0.1)).isLessThan(0.1);
    }

    /** Two balls that pass each other in mid-step, each by one radius a step. */
    private static Motion passing(double depth) {
        double aside = (1 - depth) / 2;
        return Scene.of(
                Scene.ball("A", 0.5).position(-0.25, aside, 0).velocity(5, 0, 0).build(),
                Scene.ball("B", 0.5).position(0.25, -aside, 0).velocity(-5, 0, 0).build());
    }

    @Test
    void theEarliestOfSeveralPairsIsFound() {
        Motion motion =
                Scene.of(
                        Scene.ball("A", 0.5).velocity(1, 0, 0).build(),
                        Scene.ball("B", 0.5).position(1.9, 0, 0).fixed().build(),
                        Scene.ball("C", 0.5).position(0, 5, 0).velocity(1, 0, 0).build(),
                        Scene.ball("D", 0.5).position(1.82, 5, 0).fixed().build());

        assertThat(find(new BisectionFinder(1, 50), motion, 1)).isEqualTo(0.82, within(1e-12));
    }

    @Test
    void lookingAtTheEndOfTheStepAllowsOverlap() {
        Motion motion = Scene.of(PairQueries.standard(), approach());

        assertThat(find(new EndOfStepFinder(), motion, 1)).isEqualTo(1);
        assertThat(motion.overlap(0, 1, 1)).isTrue();
        assertThat(motion.position(0, 1).distance(motion.position(1, 1)))
                .isEqualTo(0.7, within(1e-12));
    }

    @Test
    void limitsAreChecked() {
        assertThatThrownBy(() -> new BisectionFinder(0, 40))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("needs 1 or more indices and iterations, but has 0 and 40");
        assertThatThrownBy(() -> new BisectionFinder(10, 0))
                .isInstanceOf(IllegalArgumentException.class);
    }
}
