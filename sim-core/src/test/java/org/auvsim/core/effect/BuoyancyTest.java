package org.auvsim.core.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.AddedMass;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.OptionalDouble;

class BuoyancyTest {
    private static final double G = 9.80665;

    private static Buoyancy of(double volume, Vec3 centre, double height) {
        return new Buoyancy(volume, 1025, G, centre, 0, OptionalDouble.of(height));
    }

    private static WorldObjectDefinition.Builder buoy(double mass, double z) {
        return WorldObjectDefinition.named("buoy")
                .volume(new Box(new Vec3(1, 1, 1)))
                .mass(mass)
                .position(0, 0, z)
                .effect(new Gravity(G));
    }

    private static World world(WorldObjectDefinition.Builder body, double dt) {
        return World.builder().timeStep(dt).add(body.build()).build();
    }

    @Test
    void aBodyAsHeavyAsItsWaterHovers() {
        World world = world(buoy(1025, -5).effect(of(1, Vec3.ZERO, 1)), 0.05);
        world.advanceTimestep();
        assertThat(world.object("buoy").velocity().norm()).isLessThan(1e-13);
    }

    /** Half as heavy as its water an upright box floats half wet, and heaves as a spring does. */
    @Test
    void aFloatingBoxHeavesWithThePeriodOfItsWaterplane() {
        double mass = 1025 / 2.0;
        World world = world(buoy(mass, 0.1).effect(of(1, Vec3.ZERO, 1)), 0.002);
        double omega = Math.sqrt(1025 * G / mass);
        double worst = 0;
        while (world.time() < 3) {
            world.advanceTimestep();
            double exact = 0.1 * Math.cos(omega * world.time());
            worst = Math.max(worst, Math.abs(world.object("buoy").position().z() - exact));
        }
        assertThat(worst).isLessThan(1e-9);
    }

    @Test
    void aDryBodyFeelsNothing() {
        World world = world(buoy(2, 3).effect(of(1, Vec3.ZERO, 1)), 0.05);
        world.advanceTimestep();
        assertThat(world.object("buoy").velocity().z()).isCloseTo(-G * 0.05, within(1e-14));
    }

    /** The centre of buoyancy above that of mass rights a body: a pendulum of small angles. */
    @Test
    void aCentreOfBuoyancyAboveTheCentreOfMassRightsTheBody() {
        double angle = 1e-4;
        World world =
                world(
                        buoy(1025, -5)
                                .orientation(
                                        new Quat(Math.cos(angle / 2), Math.sin(angle / 2), 0, 0))
                                .effect(of(1, new Vec3(0, 0, 0.1), 1)),
                        0.01);
        double inertia = 1025 / 6.0;
        double omega = Math.sqrt(1025 * G * 0.1 / inertia);
        while (world.time() < 2 * Math.PI / omega - 0.005) {
            world.advanceTimestep();
        }
        assertThat(2 * world.object("buoy").orientation().x())
                .isCloseTo(angle * Math.cos(omega * world.time()), within(angle * 1e-4));
    }

    @Test
    void twoFloatsOfABodyAddUp() {
        World world =
                world(
                        buoy(1025, -5)
                                .effect(of(0.25, new Vec3(0.4, 0, 0), 1))
                                .effect(of(0.75, new Vec3(-0.4 / 3, 0, 0), 1)),
                        0.05);
        world.advanceTimestep();
        WorldObject buoy = world.object("buoy");
        assertThat(buoy.velocity().norm()).isLessThan(1e-13);
        assertThat(buoy.angularVelocity().norm()).isLessThan(1e-13);
    }

    /** Water that oscillates as a whole takes along what is as heavy, whatever its added mass. */
    @Test
    void aNeutralBodyMovesWithWaterThatOscillates() {
        record Swell(long id, String name) implements Current {
            @Override
            public Vec3 valueAt(Vec3 position, double time) {
                return new Vec3(0.5 * StrictMath.sin(2 * time), 0, 0);
            }
        }
        World world =
                World.builder()
                        .timeStep(0.01)
                        .add(new Swell(9, "swell"))
                        .add(
                                buoy(1025, -5)
                                        .addedMass(
                                                new AddedMass(
                                                        new Vec3(300, 500, 700),
                                                        Vec3.ZERO,
                                                        List.of()))
                                        .effect(of(1, Vec3.ZERO, 1))
                                        .build())
                        .build();
        while (world.time() < 4) {
            world.advanceTimestep();
            assertThat(world.object("buoy").velocity().x())
                    .isCloseTo(0.5 * Math.sin(2 * world.time()), within(1e-7));
        }
    }

    /**
     * In a steady strain u = s (x, -y, 0) Du/Dt is s^2 (x, y, 0), in shear it is not zero either.
     */
    @Test
    void unevenWaterAcceleratesAlongItsPaths() {
        record Strain(long id, String name) implements Current {
            @Override
            public Vec3 valueAt(Vec3 position, double time) {
                return new Vec3(0.3 * position.x(), -0.3 * position.y(), 0);
            }
        }
        World world =
                World.builder()
                        .timeStep(0.01)
                        .add(new Strain(9, "strain"))
                        .add(
                                buoy(1025, -5)
                                        .position(1, 2, -5)
                                        .velocity(0.3, -0.6, 0)
                                        .effect(of(1, Vec3.ZERO, 1))
                                        .build())
                        .build();
        while (world.time() < 2) {
            world.advanceTimestep();
        }
        Vec3 place = world.object("buoy").position();
        assertThat(place.x()).isCloseTo(Math.exp(0.3 * world.time()), within(1e-7));
        assertThat(place.y()).isCloseTo(2 * Math.exp(-0.3 * world.time()), within(1e-7));
    }

    @Test
    void whatCannotBeIsRefusedByName() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> of(-1, Vec3.ZERO, 1))
                .withMessage(
                        "the volume of buoyancy must be 0 m^3 or more and finite, but is -1.0 m^3");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> of(1, Vec3.ZERO, 0))
                .withMessageContaining("the height of buoyancy must be above 0 m");
    }
}
