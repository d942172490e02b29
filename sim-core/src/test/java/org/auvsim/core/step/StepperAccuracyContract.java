package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.Change;
import org.auvsim.core.entity.CollisionResponse;
import org.auvsim.core.entity.Contact;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.reference.Swarm;
import org.auvsim.core.volume.Box;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.auvsim.core.world.WorldEvent;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * What every {@link Stepper} keeps that goes through the collisions of a step one by one, each at
 * its instant; extend it to test one of your own. What it is held against is solved without it.
 */
public abstract class StepperAccuracyContract {
    private static final double DT = 0.05;

    /** Shallower grazes (share of the radius) may be overlooked by a search that samples. */
    private static final double GRAZE = 0.03;

    /** The stepper, made to cope with speeds of up to 10 m/s. */
    protected abstract Stepper stepper();

    @ParameterizedTest(name = "{0} balls, seed {1}, {2} s")
    @CsvSource({"10, 1, 1.5", "10, 2, 1.5", "20, 3, 1.2", "40, 4, 1.0", "100, 5, 0.6"})
    void onSmoothForcesTheCollisionsAreThoseOfTheExactSolution(int n, long seed, double end) {
        SpringSwarm swarm = new SpringSwarm(seed, n);
        List<Swarm.Meeting> exact = swarm.meetings(end, GRAZE);

        List<Swarm.Meeting> met =
                SpringSwarm.collisions(swarm.world(stepper(), 0.005), end).stream()
                        .limit(exact.size())
                        .toList();

        assertThat(exact).hasSizeGreaterThanOrEqualTo(8);
        assertThat(pairs(met)).isEqualTo(pairs(exact));
        for (int k = 0; k < exact.size(); k++) {
            assertThat(met.get(k).time())
                    .as("collision %d of %d, %s", k + 1, exact.size(), exact.get(k))
                    .isEqualTo(exact.get(k).time(), within(1e-9));
        }
    }

    private static List<String> pairs(List<Swarm.Meeting> meetings) {
        return meetings.stream().map(m -> m.first() + " and " + m.second()).toList();
    }

    @ParameterizedTest(name = "{0} balls, seed {1}, {2} s")
    @CsvSource({"10, 11, 1", "10, 12, 1", "10, 13, 1", "30, 14, 0.8", "100, 15, 0.6"})
    void theErrorFallsWithTheFourthPowerOfTheTimeStep(int n, long seed, double end) {
        double[] steps = {0.04, 0.02, 0.01, 0.005};
        double[] errors = new double[steps.length];
        for (int i = 0; i < steps.length; i++) {
            SpringSwarm swarm = new SpringSwarm(seed, n);
            World world = swarm.world(stepper(), steps[i]);
            assertThat(SpringSwarm.collisions(world, end)).hasSizeGreaterThan(2);
            errors[i] = swarm.error(world);
        }
        assertThat(order(steps, errors))
                .as("errors %s", Arrays.toString(errors))
                .isGreaterThan(3.5);
    }

    /** Slope of the logarithms, by least squares. */
    private static double order(double[] x, double[] y) {
        double meanX = 0;
        double meanY = 0;
        for (int i = 0; i < x.length; i++) {
            meanX += StrictMath.log(x[i]) / x.length;
            meanY += StrictMath.log(y[i]) / x.length;
        }
        double above = 0;
        double below = 0;
        for (int i = 0; i < x.length; i++) {
            double dx = StrictMath.log(x[i]) - meanX;
            above += dx * (StrictMath.log(y[i]) - meanY);
            below += dx * dx;
        }
        return above / below;
    }

    private WorldBuilder world() {
        return World.builder().timeStep(DT).stepper(stepper());
    }

    private static List<Contact> run(World world, double end) {
        List<Contact> contacts = new ArrayList<>();
        world.addListener(
                event -> {
                    if (event instanceof WorldEvent.Collided(double _, Collision collision)) {
                        contacts.add(collision.contact());
                    }
                });
        while (world.time() < end) {
            world.advanceTimestep(Math.min(DT, end - world.time()));
        }
        return contacts;
    }

    @Test
    void aBallThrownIntoACornerBouncesOffWallAndFloor() {
        World world =
                world().add(
                                Scene.ball("Ball", 0.5)
                                        .velocity(3, 0, 4)
                                        .effect(new Gravity(9.81))
                                        .build())
                        .add(fixed("Wall", new Vec3(1, 8, 8)).position(2.5, 0, 0).build())
                        .add(fixed("Floor", new Vec3(8, 8, 1)).position(0, 0, -1.5).build())
                        .build();

        List<Contact> contacts = run(world, 1.4);

        // x: 1.5 m at 3 m/s; z: 4 t - 4.905 t^2 = -0.5, arriving with sqrt(16 + 9.81).
        double landing = (4 + Math.sqrt(16 + 9.81)) / 9.81;
        assertThat(contacts).hasSize(2);
        assertThat(contacts.get(0).time()).isEqualTo(0.5, within(1e-9));
        assertThat(contacts.get(1).time()).isEqualTo(landing, within(1e-9));
        double after = 1.4 - landing;
        double up = Math.sqrt(16 + 9.81);
        Vec3 place = new Vec3(1.5 - 3 * 0.9, 0, -0.5 + (up - 4.905 * after) * after);
        assertThat(world.object("Ball").position().distance(place)).isLessThan(1e-8);
    }

    private static WorldObjectDefinition.Builder fixed(String name, Vec3 size) {
        return WorldObjectDefinition.named(name).volume(new Box(size)).fixed();
    }

    /** Leaves the world and pushes its neighbours away. */
    private record Mine(List<Long> neighbours) implements CollisionResponse {
        Vec3 push(int i) {
            return new Vec3(StrictMath.cos(i), StrictMath.sin(i), 0).times(5 - 0.5 * i);
        }

        @Override
        public List<Change> respond(Contact contact) {
            List<Change> changes = new ArrayList<>();
            changes.add(new Change.Remove(contact.self().id()));
            for (int i = 0; i < neighbours.size(); i++) {
                changes.add(new Change.Momentum(neighbours.get(i), push(i), Vec3.ZERO));
            }
            return changes;
        }
    }

    /**
     * Of the five pushed by the mine the first meets a wall in the same step of 0.05 s, 0.02 s
     * later.
     */
    @Test
    void aMineMovesItsFiveNeighboursInMidStepAndIsGone() {
        Mine mine = new Mine(List.of(11L, 12L, 13L, 14L, 15L));
        WorldBuilder builder =
                world().add(Scene.ball("Mine", 0.5).response(mine).build())
                        .add(
                                Scene.ball("Vehicle", 0.5)
                                        .position(0, 0, 1.02)
                                        .velocity(0, 0, -2)
                                        .build())
                        .add(Scene.ball("Wall", 0.5).position(5.1, 0, 0).fixed().build());
        for (int i = 0; i < 5; i++) {
            Vec3 place = new Vec3(StrictMath.cos(i), StrictMath.sin(i), 0).times(4);
            builder.add(Scene.ball("Ball " + i, 0.5).id(11 + i).position(place).build());
        }
        World world = builder.build();

        List<Contact> contacts = run(world, 0.2);

        assertThat(contacts).hasSize(2);
        assertThat(contacts.get(0).time()).isEqualTo(0.01, within(1e-9));
        assertThat(contacts.get(1).time()).isEqualTo(0.03, within(1e-9));
        assertThat(world.objects()).noneMatch(o -> o.name().equals("Mine"));
        assertThat(world.object("Vehicle").velocity().norm()).isLessThan(1e-9);
        assertThat(world.object("Ball 0").position().distance(new Vec3(4.1 - 5 * 0.17, 0, 0)))
                .isLessThan(1e-8);
        for (int i = 1; i < 5; i++) {
            Vec3 way = mine.push(i).times(0.19);
            Vec3 from = new Vec3(StrictMath.cos(i), StrictMath.sin(i), 0).times(4);
            assertThat(world.object("Ball " + i).position().distance(from.plus(way)))
                    .as("ball %d", i)
                    .isLessThan(1e-8);
        }
    }

    @Test
    void anExpandingWaveMeetsEachBallOnceWhenItReachesIt() {
        CollisionResponse swept =
                contact ->
                        List.of(
                                new Change.Momentum(
                                        contact.self().id(), contact.normal().times(2), Vec3.ZERO));
        World world =
                world().add(
                                Scene.ball("Comes", 0.5)
                                        .position(3, 0, 0)
                                        .velocity(-1, 0, 0)
                                        .response(swept)
                                        .build())
                        .add(
                                Scene.ball("Flees", 0.5)
                                        .position(0, 1, 0)
                                        .velocity(0, 3, 0)
                                        .response(swept)
                                        .build())
                        .build();
        world.add(new Ripple(99, 6, List.of()));

        List<Contact> contacts = run(world, 0.8);

        // 3 - t = 0.6 + 6 t and 1 + 3 t = 0.6 + 6 t.
        assertThat(contacts).hasSize(2);
        assertThat(contacts.get(0).time()).isEqualTo(0.4 / 3, within(1e-9));
        assertThat(contacts.get(1).time()).isEqualTo(2.4 / 7, within(1e-9));
        assertThat(world.object("Comes").velocity().distance(new Vec3(1, 0, 0))).isLessThan(1e-9);
        assertThat(world.object("Flees").velocity().distance(new Vec3(0, 5, 0))).isLessThan(1e-9);
    }
}
