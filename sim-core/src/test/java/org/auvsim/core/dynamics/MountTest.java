package org.auvsim.core.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.math.Near.assertNear;

import org.apache.commons.math3.ode.FirstOrderDifferentialEquations;
import org.apache.commons.math3.ode.nonstiff.DormandPrince853Integrator;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.Held;
import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.Mobility;
import org.auvsim.core.entity.Mount;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.Pinned;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.OscillatingCurrent;
import org.auvsim.core.field.VortexCurrent;
import org.auvsim.core.field.VortexProfile;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

class MountTest {
    private static final Vec3 PUSH = new Vec3(3, -2, 5);

    private static WorldObjectDefinition.Builder body(Mount mount) {
        return WorldObjectDefinition.named("body")
                .volume(new Box(new Vec3(1, 1, 1)))
                .mass(2)
                .inertia(new Inertia(0.1, 0.3, 0.25, 0, 0, 0))
                .mount(mount);
    }

    @Test
    void aPendulumSwingsAsItsEquationSays() {
        Vec3 y = new Vec3(0, 1, 0);
        double length = 0.8;
        double start = 2.5;
        Flight flight =
                Flight.of(
                                body(new Pinned(Optional.of(y)))
                                        .centreOfMass(new Vec3(0, 0, -length))
                                        .orientation(Quat.ofAxisAngle(y, start)))
                        .with(new Gravity(9.81));
        flight.advance(new Rk4(), 0.001, 5000);
        double expected = pendulum(2 * 9.81 * length / (0.3 + 2 * length * length), start, 5);
        Vec3 bob = flight.body().orientation().rotate(new Vec3(0, 0, -1));
        assertThat(bob.x()).isCloseTo(-StrictMath.sin(expected), within(1e-8));
        assertThat(bob.z()).isCloseTo(-StrictMath.cos(expected), within(1e-8));
        assertThat(flight.body().position()).isEqualTo(Vec3.ZERO);
        assertThat(flight.body().linearMomentum()).isEqualTo(Vec3.ZERO);
        assertThat(flight.body().angularMomentum().x()).isZero();
        assertThat(flight.body().angularMomentum().z()).isZero();
    }

    /** The angle of a pendulum let go at {@code start} after a time: a'' = -k sin a. */
    private static double pendulum(double k, double start, double time) {
        FirstOrderDifferentialEquations equation =
                new FirstOrderDifferentialEquations() {
                    @Override
                    public int getDimension() {
                        return 2;
                    }

                    @Override
                    public void computeDerivatives(double t, double[] a, double[] rate) {
                        rate[0] = a[1];
                        rate[1] = -k * StrictMath.sin(a[0]);
                    }
                };
        double[] a = {start, 0};
        new DormandPrince853Integrator(1e-8, 1, 1e-12, 1e-12).integrate(equation, 0, a, time, a);
        return a[0];
    }

    @Test
    void aTopOnItsPointKeepsItsEnergyAndItsSpinAboutTheVertical() {
        Flight flight =
                Flight.of(
                                body(new Pinned(Optional.empty()))
                                        .inertia(new Inertia(0.2, 0.2, 0.1, 0, 0, 0))
                                        .centreOfMass(new Vec3(0, 0, 0.5))
                                        .orientation(Quat.ofAxisAngle(new Vec3(1, 0, 0), 0.4))
                                        .angularVelocity(0.3, 0, 30))
                        .with(new Gravity(9.81));
        double vertical = flight.body().angularMomentum().z();
        double energy = energyOfTop(flight);
        flight.advance(new Rk4(), 0.0005, 4000);
        assertThat(flight.body().position()).isEqualTo(Vec3.ZERO);
        assertThat(flight.body().angularMomentum().z()).isCloseTo(vertical, within(1e-9));
        assertThat(energyOfTop(flight)).isCloseTo(energy, within(1e-7));
    }

    private static double energyOfTop(Flight flight) {
        double height = flight.body().orientation().rotate(new Vec3(0, 0, 0.5)).z();
        return flight.kineticEnergy() + 2 * 9.81 * height;
    }

    @Test
    void aCarriageLetsItsBodyMoveAlongTheFreeDirectionsAlone() {
        Flight flight =
                Flight.of(
                        body(new Held(false, true, true, true, true, false))
                                .centreOfMass(new Vec3(0.2, 0.1, 0))
                                .velocity(1, 2, 3)
                                .angularVelocity(1, 2, 0.5)
                                .force(NamedForce.direct("push", Frame.WORLD, PUSH)));
        assertNear(flight.body().velocity(), new Vec3(1, 0, 0), 1e-14);
        assertNear(flight.body().angularVelocity(), new Vec3(0, 0, 0.5), 1e-14);
        flight.advance(new Rk4(), 0.01, 200);
        assertThat(flight.body().position().y()).isZero();
        assertThat(flight.body().position().z()).isZero();
        assertThat(flight.body().orientation().x()).isZero();
        assertThat(flight.body().linearMomentum().y()).isZero();
        assertThat(flight.body().angularMomentum().x()).isZero();
        assertThat(flight.body().linearMomentum().x()).isGreaterThan(6);
    }

    @Test
    void aHeldBodyOfGeneralFormKeepsItsEnergyWithoutForces() {
        Flight flight =
                Flight.of(
                        FullMassTest.vehicle()
                                .mount(new Held(false, false, true, true, true, false)));
        double energy = flight.kineticEnergy();
        flight.advance(new Rk4(), 0.001, 5000);
        assertThat(flight.kineticEnergy() / energy).isCloseTo(1, within(1e-9));
        assertThat(flight.body().position().z()).isZero();
    }

    /** A mount that holds nothing: the equations of one mounted body and those of whole blocks. */
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void aBodyOnAMountThatHoldsNothingMovesAsAFreeOne(long seed) {
        Mount holdsNothing = new Held(false, false, false, false, false, false);
        List<WorldObjectDefinition> pairs = new ArrayList<>();
        for (int k = 0; k < 5; k++) {
            pairs.add(drawn(seed + 10L * k).build());
            pairs.add(drawn(seed + 10L * k).mount(holdsNothing).build());
        }
        Flight flight =
                Flight.of(pairs)
                        .in(new VortexCurrent(1, "eddy", 4, 1, 6, 2, VortexProfile.LAMB_OSEEN))
                        .in(new OscillatingCurrent(2, "tide", PUSH, new Vec3(1, 0.5, 0.2), 3, 0));
        flight.advance(new Rk4(), 0.001, 1);
        for (int k = 0; k < pairs.size(); k += 2) {
            WorldObject free = flight.body(k);
            WorldObject held = flight.body(k + 1);
            assertThat(free.position().distance(pairs.get(k).position())).isPositive();
            assertNear(held.position(), free.position(), 1e-12);
            assertNear(held.linearMomentum(), free.linearMomentum(), 1e-12);
            assertNear(held.angularMomentum(), free.angularMomentum(), 1e-12);
            assertNear(held.velocity(), free.velocity(), 1e-12);
            assertNear(held.angularVelocity(), free.angularVelocity(), 1e-12);
        }
    }

    private static WorldObjectDefinition.Builder drawn(long seed) {
        Draws draws = new Draws(seed);
        Vec3 v = draws.vector(1);
        Vec3 w = draws.vector(0.5);
        return FullMassTest.vehicle()
                .position(draws.vector(3))
                .orientation(draws.orientation())
                .velocity(v.x(), v.y(), v.z())
                .angularVelocity(w.x(), w.y(), w.z());
    }

    @Test
    void whatHitsAPinnedBodyFeelsTheInertiaAboutThePin() {
        Flight flight = Flight.of(body(new Pinned(Optional.empty())));
        Mobility mobility = flight.body().mobility();
        Vec3 arm = new Vec3(0, 0, 0.5);
        Vec3 yielding = mobility.velocityAt(arm, new Vec3(1, 0, 0));
        assertNear(yielding, new Vec3(0.25 / 0.3, 0, 0), 1e-14);
        assertNear(mobility.velocityAt(arm, new Vec3(0, 0, 1)), Vec3.ZERO, 1e-15);
    }
}
