package org.auvsim.core.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Mooring and tether. */
class LinesTest {
    private static final Vec3 EYE = new Vec3(0.5, 0.2, -0.1);

    private static WorldObjectDefinition.Builder buoy(String name, double x) {
        return WorldObjectDefinition.named(name)
                .volume(new Box(new Vec3(1, 0.6, 0.4)))
                .mass(3)
                .ignores(0)
                .position(x, 0, 0);
    }

    private static World world(WorldObjectDefinition... objects) {
        var builder = World.builder().timeStep(0.005);
        for (WorldObjectDefinition object : objects) {
            builder.add(object);
        }
        return builder.build();
    }

    private static void run(World world, double until) {
        while (world.time() < until) {
            world.advanceTimestep();
        }
    }

    /** Kinetic energy (J). */
    private static double kinetic(WorldObject body) {
        return (body.linearMomentum().dot(body.velocity())
                        + body.angularMomentum().dot(body.angularVelocity()))
                / 2;
    }

    private static Vec3 end(WorldObject body, Vec3 point) {
        return body.position().plus(body.orientation().rotate(point));
    }

    private static double stretched(double distance, double length, double stiffness) {
        double stretch = Math.max(0, distance - length);
        return stiffness * stretch * stretch / 2;
    }

    /** m x'' = -k (x - length): a cosine about the length while taut, then a straight flight. */
    @Test
    void aMooredBuoySwingsOnItsTautLineAndFliesFreeOnceItIsSlack() {
        World world =
                world(
                        buoy("buoy", 2.5)
                                .effect(new Mooring(Vec3.ZERO, Vec3.ZERO, 2, 12, 0))
                                .build());
        run(world, 0.5);
        WorldObject buoy = world.object("buoy");
        assertThat(buoy.position().x())
                .isCloseTo(2 + 0.5 * StrictMath.cos(2 * world.time()), within(1e-8));
        run(world, 1.5);
        double slackSince = Math.PI / 4;
        assertThat(buoy.position().x()).isCloseTo(2 - (world.time() - slackSince), within(2e-5));
        assertThat(buoy.velocity().x()).isCloseTo(-1, within(2e-5));
    }

    @Test
    void aMooringWithoutDampingKeepsEnergyOfBodyAndLine() {
        Mooring mooring = new Mooring(new Vec3(0, 0, 1), EYE, 2, 8, 0);
        World world =
                world(
                        buoy("buoy", 3)
                                .velocity(0, 1.5, 0.3)
                                .angularVelocity(0.3, 0.2, -0.5)
                                .effect(mooring)
                                .build());
        WorldObject buoy = world.object("buoy");
        double before = energy(buoy, mooring);
        double least = Double.POSITIVE_INFINITY;
        while (world.time() < 10) {
            world.advanceTimestep();
            assertThat(energy(buoy, mooring)).isCloseTo(before, within(1e-3));
            least = Math.min(least, kinetic(buoy));
        }
        assertThat(least).isLessThan(0.7 * before);
    }

    private static double energy(WorldObject buoy, Mooring mooring) {
        double distance = end(buoy, mooring.point()).distance(mooring.anchor());
        return kinetic(buoy) + stretched(distance, mooring.length(), mooring.stiffness());
    }

    @Test
    void aDampedMooringTakesEnergyAndNeverPushes() {
        Mooring mooring = new Mooring(Vec3.ZERO, EYE, 2, 8, 6);
        World world = world(buoy("buoy", 3).velocity(0.5, 1, 0).effect(mooring).build());
        WorldObject buoy = world.object("buoy");
        double energy = energy(buoy, mooring);
        double begin = energy;
        Vec3 momentum = buoy.linearMomentum();
        while (world.time() < 10) {
            world.advanceTimestep();
            Vec3 pulled = buoy.linearMomentum().minus(momentum);
            assertThat(pulled.dot(end(buoy, EYE))).isLessThan(1e-9);
            assertThat(energy(buoy, mooring)).isLessThan(energy + 1e-6);
            energy = energy(buoy, mooring);
            momentum = buoy.linearMomentum();
        }
        assertThat(energy).isLessThan(0.8 * begin);
    }

    @Test
    void aTetherKeepsTheMomentaAndTheEnergyOfItsPair() {
        Tether tether = new Tether(2, EYE, new Vec3(-0.5, 0, 0.1), 2, 20, 0);
        World world =
                world(
                        buoy("a", 0).id(1).velocity(0, 0.8, 0).effect(tether).build(),
                        buoy("b", 3.2).id(2).angularVelocity(0.2, -0.1, 0.4).build());
        WorldObject a = world.object("a");
        WorldObject b = world.object("b");
        Vec3 linear = linear(a, b);
        Vec3 angular = angular(a, b);
        double energy = energy(a, b, tether);
        double most = 0;
        while (world.time() < 10) {
            world.advanceTimestep();
            assertNear(linear(a, b), linear, 1e-12);
            assertNear(angular(a, b), angular, 1e-6);
            assertThat(energy(a, b, tether)).isCloseTo(energy, within(1e-4));
            most = Math.max(most, b.velocity().norm());
        }
        assertThat(most).isGreaterThan(0.5);
    }

    private static Vec3 linear(WorldObject a, WorldObject b) {
        return a.linearMomentum().plus(b.linearMomentum());
    }

    private static Vec3 angular(WorldObject a, WorldObject b) {
        return aboutTheWorld(a).plus(aboutTheWorld(b));
    }

    private static Vec3 aboutTheWorld(WorldObject body) {
        return body.position().cross(body.linearMomentum()).plus(body.angularMomentum());
    }

    private static double energy(WorldObject a, WorldObject b, Tether tether) {
        double distance = end(a, tether.point()).distance(end(b, tether.toPoint()));
        return kinetic(a) + kinetic(b) + stretched(distance, tether.length(), tether.stiffness());
    }

    @Test
    void aSlackTetherDoesNothing() {
        World world =
                world(
                        buoy("a", 0)
                                .id(1)
                                .velocity(0.3, 0, 0)
                                .effect(new Tether(2, Vec3.ZERO, Vec3.ZERO, 5, 20, 3))
                                .build(),
                        buoy("b", 2).id(2).build());
        run(world, 1);
        assertNear(world.object("a").velocity(), new Vec3(0.3, 0, 0), 1e-15);
        assertThat(world.object("b").velocity()).isEqualTo(Vec3.ZERO);
    }

    @ParameterizedTest
    @CsvSource({
        "-1, 1, 0, 'length of %s must be 0 m or more and finite, but is -1.0 m'",
        "1, 0, 0, 'stiffness of %s must be above 0 N/m and finite, but is 0.0 N/m'",
        "1, 1, NaN, 'damping of %s must be 0 N s/m or more and finite, but is NaN N s/m'"
    })
    void linesThatWouldPushAreRefused(
            double length, double stiffness, double damping, String message) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Mooring(Vec3.ZERO, EYE, length, stiffness, damping))
                .withMessage("the " + message.formatted("a mooring"));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Tether(1, EYE, EYE, length, stiffness, damping))
                .withMessage("the " + message.formatted("a tether"));
    }

    @Test
    void placesThatAreNowhereAreRefused() {
        Vec3 nowhere = new Vec3(Double.NaN, 0, 0);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Mooring(nowhere, EYE, 1, 1, 0))
                .withMessageStartingWith("the anchor of a mooring must be finite, but is (NaN");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Tether(1, EYE, nowhere, 1, 1, 0))
                .withMessageContaining("the other body's point of a tether");
    }
}
