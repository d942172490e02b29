package org.auvsim.core.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.Bodies;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

class CentralForceTest {
    private static final Vec3 TARGET = new Vec3(1, -2, 3);
    private static final CentralForce FORCE = new CentralForce(10, 0.1, TARGET);

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void pullsTowardItsTargetOrRests(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Block block = new Block();
        block.take(0, Block.SIZE);
        List<List<Effect>> effects = new ArrayList<>();
        List<Vec3> expected = new ArrayList<>();
        for (int i = 0; i < Block.SIZE; i++) {
            // Half of them near the rest radius; every fourth without, every fourth with two.
            Vec3 place = TARGET.plus(draw(random, i % 2 == 0 ? 20 : 0.1));
            Vec3 other = draw(random, 5);
            effects.add(
                    List.<Effect>of(FORCE, new CentralForce(3, 0, other))
                            .subList(0, i % 4 == 0 ? 0 : i % 4 == 3 ? 2 : 1));
            put(block, i, place);
            expected.add(sum(effects.get(i), place));
        }

        FORCE.layOut(effects, new Bodies().surroundings()).add(block);

        for (int i = 0; i < Block.SIZE; i++) {
            assertNear(new Vec3(block.fx[i], block.fy[i], block.fz[i]), expected.get(i), 1e-12);
        }
    }

    /** As the comment of the force says it. */
    private static Vec3 sum(List<Effect> effects, Vec3 place) {
        Vec3 sum = Vec3.ZERO;
        for (Effect effect : effects) {
            CentralForce f = (CentralForce) effect;
            Vec3 way = f.target().minus(place);
            if (way.norm() > f.restRadius()) {
                sum = sum.plus(way.times(f.force() / way.norm()));
            }
        }
        return sum;
    }

    private static Vec3 draw(SplittableRandom random, double reach) {
        return new Vec3(
                random.nextDouble(-reach, reach),
                random.nextDouble(-reach, reach),
                random.nextDouble(-reach, reach));
    }

    private static void put(Block block, int i, Vec3 place) {
        block.state[BodyState.X][i] = place.x();
        block.state[BodyState.Y][i] = place.y();
        block.state[BodyState.Z][i] = place.z();
    }

    @ParameterizedTest
    @CsvSource({"0.1, 0", "0.1000001, -10", "0.0999999, 0"})
    void theSwitchIsSharp(double distance, double force) {
        Block block = new Block();
        block.take(0, 1);
        CentralForce atOrigin = new CentralForce(10, 0.1, Vec3.ZERO);
        put(block, 0, new Vec3(distance, 0, 0));

        atOrigin.layOut(List.of(List.of(atOrigin)), new Bodies().surroundings()).add(block);

        assertThat(block.fx[0]).isCloseTo(force, within(1e-12));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-170, 1e-3, 1e150})
    void givesANumberAtAnyDistance(double distance) {
        Block block = new Block();
        block.take(0, 1);
        CentralForce sharp = new CentralForce(10, 0, Vec3.ZERO);
        put(block, 0, new Vec3(0, distance, 0));

        sharp.layOut(List.of(List.of(sharp)), new Bodies().surroundings()).add(block);

        assertThat(block.fy[0]).isBetween(-10.000001, 0.0);
    }

    /** An orbit that keeps out of the rest radius: a smooth path. */
    @Test
    void keepsKineticAndPotentialEnergy() {
        World world =
                World.builder()
                        .timeStep(0.01)
                        .add(
                                WorldObjectDefinition.named("Moon")
                                        .volume(new Sphere(0.5))
                                        .mass(2)
                                        .position(3, -2, 3)
                                        .velocity(0.3, 2, 0.5)
                                        .effect(FORCE)
                                        .build())
                        .build();
        WorldObject moon = world.object("Moon");
        double before = energy(moon);
        Vec3 start = moon.position();

        while (world.time() < 10) {
            world.advanceTimestep();
        }

        assertThat(energy(moon)).isCloseTo(before, within(1e-6));
        assertThat(moon.position().distance(start)).isGreaterThan(0.1);
    }

    private static double energy(WorldObject moon) {
        double speed = moon.velocity().norm();
        return moon.mass() * speed * speed / 2 + FORCE.potentialEnergy(moon.position());
    }

    @Test
    void itsEnergyIsThatOfTheWayToTheRestRadius() {
        assertThat(FORCE.potentialEnergy(TARGET.plus(new Vec3(0, 4, 3)))).isEqualTo(50);
        assertThat(FORCE.potentialEnergy(TARGET)).isEqualTo(1);
    }
}
