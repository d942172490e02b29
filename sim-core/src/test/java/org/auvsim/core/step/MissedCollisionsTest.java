package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.reference.DrawnPair;
import org.auvsim.core.reference.Kind;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.auvsim.core.world.WorldEvent;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.LongStream;
import java.util.stream.Stream;

/**
 * The event stepper misses no first collision: 1,000 drawn worlds of two bodies for each pair of
 * volumes, each held against a reference that shares nothing with the engine. What is judged is the
 * instant of the first collision, and that the two do not overlap at the end of any step.
 *
 * <p>The reference tells from when on two bodies may touch, and when they surely do, if each of
 * their points is where it should be to within the error of the path. Grazes shallower than that
 * error are never sure; they are counted.
 */
class MissedCollisionsTest {
    private static final int SEEDS = 1000;

    /** What integration, and the path between two instants, may do to a point of a body (m). */
    private static final double PATH_ERROR = 3e-6;

    /** The same for balls under constant forces, whose paths are exact but for rounding. */
    private static final double ROUNDING = 1e-11;

    /** So many grazes of 1,000 worlds may be left out. */
    private static final int MOST_EXEMPT = 2;

    static Stream<Arguments> pairs() {
        return Kind.pairs();
    }

    @ParameterizedTest(name = "{0} and {1}, seeds 1 to " + SEEDS)
    @MethodSource("pairs")
    void everyCollisionOfTheReferenceIsMetAtItsInstant(Kind a, Kind b) {
        double error = a == Kind.SPHERE ? ofBall(b) : PATH_ERROR;
        int sure = 0;
        int exempt = 0;
        List<String> wrong = new ArrayList<>();
        List<Trial> trials =
                LongStream.rangeClosed(1, SEEDS)
                        .parallel()
                        .mapToObj(seed -> Trial.of(DrawnPair.of(a, b, seed), seed, error))
                        .toList();
        for (Trial trial : trials) {
            DrawnPair.Meeting exact = trial.exact();
            sure += exact.isSure() ? 1 : 0;
            exempt += exact.isPossible() && !exact.isSure() ? 1 : 0;
            judge(trial.seed(), exact, trial.outcome(), wrong);
        }
        assertThat(wrong).as("%d of %d meet, %d graze", sure, SEEDS, exempt).isEmpty();
        assertThat(sure).isBetween(SEEDS / 3, SEEDS - 3);
        assertThat(exempt).isLessThanOrEqualTo(MOST_EXEMPT);
    }

    private static double ofBall(Kind other) {
        return switch (other) {
            case SPHERE -> ROUNDING;
            case HALF_SPACE -> ROUNDING + ConservativeAdvancement.CONTACT;
            default -> PATH_ERROR;
        };
    }

    private static void judge(
            long seed, DrawnPair.Meeting exact, Outcome outcome, List<String> wrong) {
        double met = outcome.collision();
        if (met < exact.possible() || met > exact.sure()) {
            wrong.add(
                    "seed %d: met at %s s, possible from %s s, sure at %s s"
                            .formatted(seed, met, exact.possible(), exact.sure()));
        }
        if (outcome.overlap() < Double.POSITIVE_INFINITY) {
            wrong.add(
                    "seed %d: overlap at %s s, first met at %s s"
                            .formatted(seed, outcome.overlap(), met));
        }
    }

    /** What a world should do and what it did. */
    private record Trial(long seed, DrawnPair.Meeting exact, Outcome outcome) {
        static Trial of(DrawnPair pair, long seed, double error) {
            return new Trial(seed, pair.meeting(error), run(pair, seed));
        }
    }

    /** The first collision, and the first instant with an overlap (s); infinity for none. */
    private record Outcome(double collision, double overlap) {}

    /** Steps of 0.02 to 0.05 s, with a look at the bodies after each. */
    private static Outcome run(DrawnPair pair, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        double[] collision = {Double.POSITIVE_INFINITY};
        double overlap = Double.POSITIVE_INFINITY;
        WorldBuilder builder = World.builder().stepper(EventStepper.standard());
        pair.definitions().forEach(builder::add);
        World world = builder.build();
        world.addListener(
                event -> {
                    if (event instanceof WorldEvent.Collided(double _, Collision c)) {
                        collision[0] = Math.min(collision[0], c.contact().time());
                    }
                });
        while (world.time() < DrawnPair.END) {
            double left = DrawnPair.END - world.time();
            world.advanceTimestep(Math.min(left, random.nextDouble(0.02, 0.05)));
            if (pair.overlapIn(world, 1e-9 * pair.size())) {
                overlap = Math.min(overlap, world.time());
            }
        }
        return new Outcome(collision[0], overlap);
    }
}
