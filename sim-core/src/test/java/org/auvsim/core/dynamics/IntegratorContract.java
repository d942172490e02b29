package org.auvsim.core.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.junit.jupiter.api.Test;

import java.util.List;

/**
 * What every integrator does right, whatever its method. A test of one's own integrator extends
 * this and names it and its order.
 */
public abstract class IntegratorContract {
    private static final Vec3 ONES = new Vec3(1, 1, 1);

    /** The integrator. */
    protected abstract Integrator integrator();

    /** By what power of the time step its error falls. */
    protected abstract int order();

    /** How far the observed power may be from it. */
    protected double orderWithin() {
        return 0.2;
    }

    /** In how many steps its error over 4 s is the coarser of the two that show the order. */
    protected int coarseSteps() {
        return 40;
    }

    private static WorldObjectDefinition.Builder ball() {
        return WorldObjectDefinition.named("ball").volume(new Sphere(1)).mass(2);
    }

    @Test
    void aFreeBodyGoesStraightOn() {
        Flight flight = Flight.of(ball().position(1, 2, 3).velocity(4, 5, 6));
        flight.advance(integrator(), 0.05, 200);
        assertNear(flight.body().position(), new Vec3(41, 52, 63), 1e-11);
        assertThat(flight.body().linearMomentum()).isEqualTo(new Vec3(8, 10, 12));
        assertThat(flight.body().orientation()).isEqualTo(Quat.IDENTITY);
    }

    @Test
    void timeGoesOnByTheStep() {
        Flight flight = Flight.of(ball());
        flight.advance(integrator(), 0.25, 8);
        assertThat(flight.time()).isEqualTo(2);
    }

    @Test
    void aConstantForceGivesAParabola() {
        NamedForce force = NamedForce.direct("pull", Frame.WORLD, new Vec3(6, 0, -4));
        Flight flight = Flight.of(ball().velocity(1, 2, 3).force(force));
        flight.advance(integrator(), 0.1, 100);
        assertNear(flight.body().velocity(), new Vec3(31, 2, -17), 1e-11);
        assertNear(flight.body().position(), new Vec3(160, 20, -70), 1e-10);
    }

    @Test
    void aForceInTheBodysAxesTurnsWithIt() {
        // At a constant turn w the velocity runs round a circle of F / (m w).
        NamedForce thrust = NamedForce.direct("thrust", Frame.BODY, new Vec3(3, 0, 0));
        Flight flight = Flight.of(ball().angularVelocity(0, 0, 0.5).force(thrust));
        flight.advance(integrator(), 0.01, 1000);
        double angle = 0.5 * 10;
        Vec3 expected =
                new Vec3(StrictMath.sin(angle), 1 - StrictMath.cos(angle), 0).times(3 / (2 * 0.5));
        assertNear(flight.body().velocity(), expected, 1e-7);
        assertNear(
                flight.body().orientation().rotate(new Vec3(1, 0, 0)),
                new Vec3(StrictMath.cos(angle), StrictMath.sin(angle), 0),
                1e-7);
    }

    @Test
    void withoutTorqueEnergyAndAngularMomentumStay() {
        Flight flight =
                Flight.of(
                        ball().inertia(new Inertia(1, 2, 2.5, 0, 0, 0))
                                .angularVelocity(1, 0.5, 0.3));
        double energy = flight.kineticEnergy();
        Vec3 angularMomentum = flight.body().angularMomentum();
        double worst = 0;
        for (int step = 0; step < 10_000; step++) {
            flight.advance(integrator(), 0.01, 1);
            worst = Math.max(worst, Math.abs(flight.kineticEnergy() / energy - 1));
        }
        assertThat(worst).isLessThan(1e-9);
        assertNear(flight.body().angularMomentum(), angularMomentum, 1e-9 * angularMomentum.norm());
    }

    @Test
    void theErrorFallsWithTheOrderOfTheMethod() {
        ReferenceVehicle vehicle = ReferenceVehicle.withSmoothForces();
        double[] truth = vehicle.solve(4);
        double coarse = errorAt(vehicle, truth, coarseSteps());
        double fine = errorAt(vehicle, truth, 2 * coarseSteps());
        double observed = StrictMath.log(coarse / fine) / StrictMath.log(2);
        assertThat(observed).isCloseTo(order(), within(orderWithin()));
    }

    @Test
    void smallStepsFollowTheIndependentSolution() {
        ReferenceVehicle vehicle = ReferenceVehicle.withQuadraticDamping();
        assertThat(errorAt(vehicle, vehicle.solve(4), 4000)).isLessThan(1e-7);
    }

    private double errorAt(ReferenceVehicle vehicle, double[] truth, int steps) {
        Flight flight = vehicle.flight();
        flight.advance(integrator(), 4.0 / steps, steps);
        return vehicle.error(flight.body(), truth);
    }

    @Test
    void orientationsStayOfLengthOneOverAMillionSteps() {
        Flight flight =
                Flight.of(
                        ball().inertia(new Inertia(1, 2, 2.5, 0, 0, 0)).angularVelocity(3, 2, -1));
        double worst = 0;
        for (int thousand = 0; thousand < 1000; thousand++) {
            flight.advance(integrator(), 0.01, 1000);
            worst = Math.max(worst, Math.abs(flight.body().orientation().norm() - 1));
        }
        assertThat(worst).isLessThan(1e-15);
    }

    @Test
    void aBlockOfManyGivesTheBitsOfManyBlocksOfOne() {
        List<WorldObjectDefinition> bodies = DrawnBodies.of(7, Block.SIZE);
        Flight together = effects(Flight.of(bodies));
        together.advance(integrator(), 0.05, 20);
        for (int i = 0; i < bodies.size(); i++) {
            Flight alone = effects(Flight.of(List.of(bodies.get(i))));
            alone.advance(integrator(), 0.05, 20);
            assertThat(together.body(i).movementState()).isEqualTo(alone.body().movementState());
        }
    }

    private static Flight effects(Flight flight) {
        return flight.with(new Gravity(9.81))
                .with(new Damping(ONES, ONES, ONES, ONES))
                .in(new UniformCurrent(1, "stream", new Vec3(0.5, -0.2, 0.1)));
    }

    @Test
    void whateverPushesAFixedBodyItStays() {
        NamedForce push = new NamedForce("push", Frame.WORLD, new Vec3(1, 2, 3), ONES);
        WorldObjectDefinition rock =
                WorldObjectDefinition.named("rock")
                        .volume(new Sphere(1))
                        .fixed()
                        .force(push)
                        .build();
        Flight flight = effects(Flight.of(List.of(rock, ball().build())));
        flight.advance(integrator(), 0.05, 100);
        assertThat(flight.body(0).position()).isEqualTo(Vec3.ZERO);
        assertThat(flight.body(0).orientation()).isEqualTo(Quat.IDENTITY);
        assertThat(flight.body(0).linearMomentum()).isEqualTo(Vec3.ZERO);
        assertThat(flight.body(0).angularMomentum()).isEqualTo(Vec3.ZERO);
        assertThat(flight.body(1).velocity().z()).isNegative();
    }
}
