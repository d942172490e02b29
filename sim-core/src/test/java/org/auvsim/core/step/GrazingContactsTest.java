package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/** Two balls that only just touch in passing: what sampled instants overlook. */
class GrazingContactsTest {
    private static final int SEEDS = 300;

    /** Two balls that pass each other in mid-flight, this deep (m) if nothing stopped them. */
    private static List<WorldObjectDefinition> passing(long seed, double depth) {
        Draws draws = new Draws(seed);
        double radiusA = draws.number(0.2, 0.8);
        double radiusB = draws.number(0.2, 0.8);
        double time = draws.number(0.3, 0.7);
        Quat turn = draws.orientation();
        Vec3 aside = turn.rotate(new Vec3(0, radiusA + radiusB - depth, 0));
        Vec3 velocityA = turn.rotate(new Vec3(draws.number(1, 5), 0, draws.number(-1, 1)));
        Vec3 velocityB = turn.rotate(new Vec3(draws.number(-5, -1), 0, draws.number(-1, 1)));
        Vec3 common = draws.vector(1);
        return List.of(
                flying("A", radiusA, aside, velocityA.plus(common), time),
                flying("B", radiusB, Vec3.ZERO, velocityB.plus(common), time));
    }

    /** A ball that would be there after {@code time} (s). */
    private static WorldObjectDefinition flying(
            String name, double radius, Vec3 there, Vec3 velocity, double time) {
        return Scene.ball(name, radius)
                .position(there.minus(velocity.times(time)))
                .velocity(velocity.x(), velocity.y(), velocity.z())
                .build();
    }

    private static boolean meet(Stepper stepper, List<WorldObjectDefinition> balls) {
        boolean[] met = {false};
        World world = World.builder().stepper(stepper).add(balls.get(0)).add(balls.get(1)).build();
        world.addListener(event -> met[0] |= event instanceof WorldEvent.Collided);
        while (world.time() < 1 && !met[0]) {
            world.advanceTimestep();
        }
        return met[0];
    }

    /** From 1 cm down to 1 nm, evenly in the logarithm. */
    private static double depth(long seed) {
        return StrictMath.pow(10, -2 - 7.0 * seed / SEEDS);
    }

    @Test
    void theEventStepperMeetsThemAllAndTheSampledSearchNotEvenHalf() {
        List<Long> missed = new ArrayList<>();
        int missedBySampling = 0;
        for (long seed = 1; seed <= SEEDS; seed++) {
            List<WorldObjectDefinition> balls = passing(seed, depth(seed));
            if (!meet(EventStepper.standard(), balls)) {
                missed.add(seed);
            }
            missedBySampling += meet(SnapshotStepper.standard(), balls) ? 0 : 1;
        }
        assertThat(missed).as("seeds of %d missed", SEEDS).isEmpty();
        assertThat(missedBySampling).isGreaterThan(SEEDS / 2);
    }

    @Test
    void whatPassesJustOutsideIsMetByNeither() {
        for (long seed = 1; seed <= SEEDS; seed++) {
            List<WorldObjectDefinition> balls = passing(seed, -depth(seed));
            assertThat(meet(EventStepper.standard(), balls)).as("seed %d", seed).isFalse();
            assertThat(meet(SnapshotStepper.standard(), balls)).as("seed %d", seed).isFalse();
        }
    }
}
