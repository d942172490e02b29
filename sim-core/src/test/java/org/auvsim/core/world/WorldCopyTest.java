package org.auvsim.core.world;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.behavior.BackAndForth;
import org.auvsim.core.behavior.GoToPoint;
import org.auvsim.core.behavior.PropulsorSchedule;
import org.auvsim.core.behavior.PropulsorSchedule.TimedLevel;
import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

class WorldCopyTest {
    /** Bodies with behaviors, propulsors, effects, a current and a wave, which collide. */
    private static World busy(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        WorldBuilder builder =
                World.builder()
                        .add(new UniformCurrent(90, "Drift", new Vec3(0.2, 0.1, 0)))
                        .add(new Wave(91, "Wave", 0.3, 1.5, 4, List.of()));
        for (int i = 0; i < 12; i++) {
            WorldObjectDefinition.Builder ball =
                    Balls.ball("Ball " + i)
                            .position(2 * (i % 3), 2 * (i / 3 % 2), 2 * (i / 6))
                            .velocity(random.nextDouble(-1, 1), random.nextDouble(-1, 1), 0)
                            .angularVelocity(0, 0, random.nextDouble(-2, 2));
            switch (i % 4) {
                case 0 -> ball.component(new GoToPoint("go", 4, 0.1, new Vec3(2, 1, 1)));
                case 1 -> ball.component(new BackAndForth("swing", 3, 0.5, new Vec3(0, 1, 0)));
                case 2 -> ball.effect(new Gravity(1)).effect(damping());
                default ->
                        ball.component(new Propulsor("screw", 5, 0, Vec3.ZERO, new Vec3(1, 0, 0)))
                                .component(
                                        new PropulsorSchedule(
                                                "schedule",
                                                "screw",
                                                List.of(
                                                        new TimedLevel(0.5, 1),
                                                        new TimedLevel(1.5, -1))));
            }
            builder.add(ball.build());
        }
        return builder.build();
    }

    private static Damping damping() {
        Vec3 some = new Vec3(0.5, 0.6, 0.7);
        return new Damping(some, some, some, Vec3.ZERO);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4})
    void aCopyInMidRunGoesOnAsTheOriginalDoes(long seed) {
        World original = busy(seed);
        while (original.time() < 1) {
            original.advanceTimestep();
        }

        World copy = original.copy();
        assertThat(copy.stateHash()).isEqualTo(original.stateHash());
        for (int step = 0; step < 200; step++) {
            assertThat(copy.advanceTimestep()).isEqualTo(original.advanceTimestep());
            assertThat(copy.stateHash()).isEqualTo(original.stateHash());
        }
        assertThat(copy.entities()).hasSameSizeAs(original.entities());
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {5, 6})
    void aRestoredWorldGoesOnAsTheFirstTime(long seed) {
        World world = busy(seed);
        while (world.time() < 1) {
            world.advanceTimestep();
        }
        World then = world.copy();
        List<Long> hashes = new ArrayList<>();
        for (int step = 0; step < 100; step++) {
            world.advanceTimestep();
            hashes.add(world.stateHash());
        }
        world.remove(3);
        world.restore(then);
        assertThat(world.stateHash()).isEqualTo(then.stateHash());
        for (long hash : hashes) {
            world.advanceTimestep();
            assertThat(world.stateHash()).isEqualTo(hash);
        }
    }

    @Test
    void aRestoredWorldKeepsItsListenersAndGivesNoIdTwice() {
        World world = busy(1);
        World then = world.copy();
        long late = world.add(Balls.ball("Late").position(50, 0, 0).build()).id();
        List<WorldEvent> heard = new ArrayList<>();
        world.addListener(heard::add);
        world.restore(then);
        assertThat(heard).isEmpty();
        assertThat(world.find(late)).isEmpty();
        long later = world.add(Balls.ball("Later").position(50, 0, 0).build()).id();
        assertThat(later).isGreaterThan(late);
        assertThat(heard).hasSize(2);
    }

    @Test
    void whatHappensToACopyDoesNotReachTheOriginal() {
        World original = busy(1);
        original.advanceTimestep();
        long before = original.stateHash();
        List<WorldEvent> heard = new ArrayList<>();
        original.addListener(heard::add);

        World copy = original.copy();
        copy.object("Ball 3").command(Propulsor.class, "screw", 0.5);
        copy.object("Ball 0").setPosition(new Vec3(40, 0, 0));
        copy.remove(91);
        copy.add(Balls.at("Newcomer", 80));
        for (int step = 0; step < 20; step++) {
            copy.advanceTimestep();
        }

        assertThat(heard).isEmpty();
        assertThat(original.stateHash()).isEqualTo(before);
        assertThat(original.find(91)).isPresent();
        assertThat(original.object("Ball 3").components(Propulsor.class).getFirst().level())
                .isZero();
    }

    @Test
    void theHashTellsADifferenceOfOneBit() {
        World world = busy(1);
        World other = world.copy();
        Vec3 p = other.object("Ball 5").position();

        other.object("Ball 5").setPosition(new Vec3(Math.nextUp(p.x()), p.y(), p.z()));

        assertThat(other.stateHash()).isNotEqualTo(world.stateHash());
    }
}
