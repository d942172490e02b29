package org.auvsim.core.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.AddedMass;
import org.auvsim.core.entity.AddedMassTerm;
import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.MotionAxis;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.util.List;

class FullMassTest {
    static final Vec3 CENTRE = new Vec3(0.1, -0.05, -0.2);
    static final Inertia INERTIA = new Inertia(1, 2, 2.5, 0.1, -0.2, 0.3);
    static final AddedMass ADDED =
            new AddedMass(
                    new Vec3(1, 5, 8),
                    new Vec3(0.2, 2, 3),
                    List.of(
                            new AddedMassTerm(MotionAxis.SWAY, MotionAxis.YAW, 1.5),
                            new AddedMassTerm(MotionAxis.HEAVE, MotionAxis.PITCH, -2)));

    static WorldObjectDefinition.Builder vehicle() {
        return WorldObjectDefinition.named("vehicle")
                .volume(new Box(new Vec3(1, 1, 1)))
                .mass(10)
                .inertia(INERTIA)
                .centreOfMass(CENTRE)
                .addedMass(ADDED)
                .velocity(1, 0.5, -0.3)
                .angularVelocity(0.4, -0.3, 0.6);
    }

    @Test
    void withoutForcesMomentaAndEnergyStay() {
        Flight flight =
                Flight.of(vehicle().angularVelocity(0.1, -0.1, 0.2).velocity(0.4, 0.05, -0.05));
        Vec3 linear = flight.body().linearMomentum();
        Vec3 angular = whole(flight);
        double energy = flight.kineticEnergy();
        double angularError = 0;
        double energyError = 0;
        for (int step = 0; step < 6000; step++) {
            flight.advance(new Rk4(), 0.01, 1);
            angularError = Math.max(angularError, whole(flight).distance(angular));
            energyError = Math.max(energyError, Math.abs(flight.kineticEnergy() / energy - 1));
        }
        assertThat(flight.body().linearMomentum()).isEqualTo(linear);
        assertThat(angularError).isLessThan(1e-12 * angular.norm());
        assertThat(energyError).isLessThan(1e-9);
        assertThat(flight.body().position().norm()).isGreaterThan(10);
    }

    private static Vec3 whole(Flight flight) {
        Vec3 about = flight.body().position().cross(flight.body().linearMomentum());
        return about.plus(flight.body().angularMomentum());
    }

    @Test
    void aDryBodyFallsAsItsCentreOfMassDoes() {
        WorldObjectDefinition.Builder dry =
                WorldObjectDefinition.named("hammer")
                        .volume(new Box(new Vec3(1, 1, 1)))
                        .mass(10)
                        .inertia(INERTIA)
                        .centreOfMass(CENTRE)
                        .angularVelocity(3, -2, 1);
        Flight flight = Flight.of(dry).with(new Gravity(9.81));
        Vec3 start = CENTRE;
        Vec3 speed = new Vec3(3, -2, 1).cross(CENTRE);
        flight.advance(new Rk4(), 0.001, 1000);
        Vec3 centre = flight.body().position().plus(flight.body().orientation().rotate(CENTRE));
        assertNear(centre, start.plus(speed).plus(new Vec3(0, 0, -9.81 / 2)), 1e-9);
        assertNear(
                flight.body().linearMomentum(), speed.plus(new Vec3(0, 0, -9.81)).times(10), 1e-9);
    }

    @Test
    void theVelocitiesOfTheDefinitionAreThoseOfTheBody() {
        Flight flight = Flight.of(vehicle());
        assertNear(flight.body().velocity(), new Vec3(1, 0.5, -0.3), 1e-14);
        assertNear(flight.body().angularVelocity(), new Vec3(0.4, -0.3, 0.6), 1e-14);
    }

    @Test
    void aBodyAtRestInMovingWaterIsCarriedByNothingButItsDamping() {
        Flight flight = Flight.of(vehicle().velocity(0, 0, 0).angularVelocity(0, 0, 0));
        flight.in(new UniformCurrent(1, "stream", new Vec3(0.5, 0.2, 0)));
        flight.with(new Damping(new Vec3(5, 5, 5), Vec3.ZERO, new Vec3(5, 5, 5), Vec3.ZERO));
        flight.advance(new Rk4(), 0.05, 4000);
        assertThat(flight.body().angularVelocity().norm()).isCloseTo(0, within(1e-6));
        assertNear(flight.body().linearMomentum(), new Vec3(5, 2, 0), 1e-4);
    }

    @ParameterizedTest
    @EnumSource(FossenWater.class)
    void theIndependentVelocityFormGivesTheSameMotion(FossenWater water) {
        FossenVehicle reference = new FossenVehicle(water);
        double[] truth = reference.solve(60);
        Flight flight = reference.flight();
        flight.advance(new Rk4(), 0.002, 30_000);
        assertThat(reference.error(flight.body(), truth)).isLessThan(1e-9);
    }
}
