package org.auvsim.core.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.auvsim.core.effect.Buoyancy;
import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.AddedMass;
import org.auvsim.core.entity.AddedMassTerm;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.MotionAxis;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/**
 * RexROV (Berg, Development and Commissioning of a DP system for ROV SF 30k, NTNU 2012; as the UUV
 * Simulator prints it), whose added mass in heave is twice its mass: to add it as a force that
 * follows the acceleration would diverge.
 */
class HeavyAddedMassTest {
    private static final double MASS = 1862.87;
    private static final double[][] ADDED = {
        {779.79, -6.8773, -103.32, 8.5426, -165.54, -7.8033},
        {-6.8773, 1222, 51.29, 409.44, -5.8488, 62.726},
        {-103.32, 51.29, 3659.9, 6.1112, -386.42, 10.774},
        {8.5426, 409.44, 6.1112, 534.9, -10.027, 21.019},
        {-165.54, -5.8488, -386.42, -10.027, 842.69, -1.1162},
        {-7.8033, 62.726, 10.775, 21.019, -1.1162, 224.32}
    };
    private static final Damping DAMPING =
            new Damping(
                    new Vec3(74.82, 69.48, 728.4),
                    new Vec3(748.22, 992.53, 1821.01),
                    new Vec3(268.8, 309.77, 105),
                    new Vec3(672, 774.44, 523.27));

    private static AddedMass added() {
        List<AddedMassTerm> terms = new ArrayList<>();
        for (MotionAxis row : MotionAxis.values()) {
            for (MotionAxis column : MotionAxis.values()) {
                if (row != column) {
                    double value = ADDED[row.index()][column.index()];
                    terms.add(new AddedMassTerm(row, column, value));
                }
            }
        }
        return new AddedMass(
                new Vec3(ADDED[0][0], ADDED[1][1], ADDED[2][2]),
                new Vec3(ADDED[3][3], ADDED[4][4], ADDED[5][5]),
                terms);
    }

    private static WorldObjectDefinition.Builder vehicle() {
        return WorldObjectDefinition.named("RexROV")
                .volume(new Box(new Vec3(2.6, 1.5, 1.6)))
                .mass(MASS)
                .inertia(new Inertia(525.39, 794.20, 691.23, 1.44, 33.41, 2.6))
                .position(0, 0, -50)
                .addedMass(added());
    }

    @Test
    void acceleratesAsItsWholeInertiaLetsIt() {
        Flight flight =
                Flight.of(
                        vehicle()
                                .force(
                                        new NamedForce(
                                                "lift",
                                                Frame.BODY,
                                                new Vec3(0, 0, 1000),
                                                Vec3.ZERO)));
        flight.advance(new Rk4(), 1e-3, 1);
        RealMatrix inertia = new Array2DRowRealMatrix(ADDED);
        inertia.setEntry(2, 5, 10.7745);
        inertia.setEntry(5, 2, 10.7745);
        for (int axis = 0; axis < 3; axis++) {
            inertia.addToEntry(axis, axis, MASS);
        }
        inertia.setSubMatrix(
                inertia.getSubMatrix(3, 5, 3, 5)
                        .add(
                                new Array2DRowRealMatrix(
                                        new double[][] {
                                            {525.39, 1.44, 33.41},
                                            {1.44, 794.20, 2.6},
                                            {33.41, 2.6, 691.23}
                                        }))
                        .getData(),
                3,
                3);
        double[] expected =
                new LUDecomposition(inertia)
                        .getSolver()
                        .solve(new ArrayRealVector(new double[] {0, 0, 1, 0, 0, 0}))
                        .toArray();
        Vec3 v = flight.body().velocity();
        Vec3 w = flight.body().angularVelocity();
        double[] actual = {v.x(), v.y(), v.z(), w.x(), w.y(), w.z()};
        for (int axis = 0; axis < 6; axis++) {
            assertThat(actual[axis]).isCloseTo(expected[axis], within(1e-10));
        }
    }

    /** With the simulator's usual step: it only ever loses energy, and comes to rest. */
    @Test
    void itsHeaveStaysStable() {
        Flight flight =
                Flight.of(vehicle().velocity(0.2, -0.1, 1.5).angularVelocity(0.1, 0.2, 0.3));
        flight.with(DAMPING);
        double energy = flight.kineticEnergy();
        double begin = energy;
        for (int step = 0; step < 2400; step++) {
            flight.advance(new Rk4(), 0.05, 1);
            assertThat(flight.kineticEnergy()).isLessThanOrEqualTo(energy);
            energy = flight.kineticEnergy();
        }
        assertThat(energy).isLessThan(1e-3 * begin);
    }

    /** Afloat in its weight and buoyancy it rises to the speed at which its drag holds the rest. */
    @Test
    void itRisesAtTheSpeedOfItsDrag() {
        double lift = (1.83826 * 1025 - MASS) * 9.80665;
        Flight flight =
                Flight.of(vehicle().position(0, 0, -500)).with(DAMPING).with(new Gravity(9.80665));
        flight.with(
                new Buoyancy(
                        1.83826, 1025, 9.80665, new Vec3(0, 0, 0.3), 0, OptionalDouble.empty()));
        flight.advance(new Rk4(), 0.05, 4000);
        double quadratic = 1821.01;
        double linear = 728.4;
        double speed =
                (Math.sqrt(linear * linear + 4 * quadratic * lift) - linear) / (2 * quadratic);
        assertThat(flight.body().velocity().z()).isCloseTo(speed, within(0.02 * speed));
    }
}
