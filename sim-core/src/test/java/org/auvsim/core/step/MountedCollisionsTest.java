package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.math.Near.assertNear;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.auvsim.core.entity.AddedMass;
import org.auvsim.core.entity.AddedMassTerm;
import org.auvsim.core.entity.Held;
import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.MotionAxis;
import org.auvsim.core.entity.Pinned;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** Collisions of bodies on mounts and with added mass, in a world, against closed forms. */
class MountedCollisionsTest {
    private static final double BALL = 2;
    private static final double SPEED = 3;
    private static final double DT = 1e-3;

    /** The gap (m) that a ball crosses in half a step. */
    private static final double GAP = SPEED * DT / 2;

    static Stream<Stepper> steppers() {
        return Stream.of(EventStepper.standard(), SnapshotStepper.standard());
    }

    private static World collided(
            Stepper stepper, WorldObjectDefinition target, WorldObjectDefinition ball) {
        World world = World.builder().stepper(stepper).add(target).add(ball).build();
        while (world.time() < DT) {
            world.advanceTimestep(DT - world.time());
        }
        assertThat(world.statistics().collisions()).isEqualTo(1);
        return world;
    }

    private static WorldObjectDefinition.Builder ball() {
        return WorldObjectDefinition.named("ball").volume(new Sphere(0.1)).mass(BALL);
    }

    private static double energy(WorldObject object) {
        return (object.linearMomentum().dot(object.velocity())
                        + object.angularMomentum().dot(object.angularVelocity()))
                / 2;
    }

    /** A ballistic pendulum: the momentum about the pin stays, w = (1 + e) m v d / (I + m d^2). */
    @ParameterizedTest
    @MethodSource("steppers")
    void aBallSetsAPinnedRodInMotion(Stepper stepper) {
        double inertia = 0.6;
        double arm = 0.7;
        double restitution = 0.5;
        World world =
                collided(
                        stepper,
                        WorldObjectDefinition.named("rod")
                                .volume(new Box(new Vec3(0.2, 0.2, 2)))
                                .mass(5)
                                .inertia(new Inertia(inertia, inertia, 0.1, 0, 0, 0))
                                .mount(new Pinned(Optional.of(new Vec3(0, 1, 0))))
                                .restitution(restitution)
                                .build(),
                        ball().position(-0.2 - GAP, 0, arm).velocity(SPEED, 0, 0).build());
        double rate = (1 + restitution) * BALL * SPEED * arm / (inertia + BALL * arm * arm);
        WorldObject rod = world.object("rod");
        assertNear(rod.angularVelocity(), new Vec3(0, rate, 0), 1e-9);
        assertThat(rod.position()).isEqualTo(Vec3.ZERO);
        assertThat(rod.linearMomentum()).isEqualTo(Vec3.ZERO);
        Vec3 after = world.object("ball").velocity();
        assertNear(after, new Vec3(rate * arm - restitution * SPEED, 0, 0), 1e-9);
        assertThat(inertia * rate + BALL * after.x() * arm)
                .isCloseTo(BALL * SPEED * arm, within(1e-9));
    }

    /** A carriage on rails takes what is across them; a ball bounces as off a wall there. */
    @ParameterizedTest
    @MethodSource("steppers")
    void aHeldBodyYieldsAlongItsRailsAlone(Stepper stepper) {
        Vec3 normal = new Vec3(-0.6, 0, 0.8);
        Vec3 from = normal.times(0.5 + 0.1 + GAP);
        World world =
                collided(
                        stepper,
                        WorldObjectDefinition.named("carriage")
                                .volume(new Sphere(0.5))
                                .mass(5)
                                .mount(new Held(false, true, true, true, true, true))
                                .build(),
                        ball().position(from).velocity(0.6 * SPEED, 0, -0.8 * SPEED).build());
        double impulse = 2 * SPEED / (0.6 * 0.6 / 5 + 1 / BALL);
        assertNear(world.object("carriage").velocity(), new Vec3(0.6 * impulse / 5, 0, 0), 1e-9);
        assertNear(world.object("ball").velocity(), normal.times(impulse / BALL - SPEED), 1e-9);
        assertThat(energy(world.object("carriage")) + energy(world.object("ball")))
                .isCloseTo(BALL * SPEED * SPEED / 2, within(1e-9));
    }

    static Stream<Arguments> hits() {
        return Stream.of(1L, 2L, 3L, 4L)
                .flatMap(seed -> steppers().map(stepper -> Arguments.of(stepper, seed)));
    }

    /** A body at rest with a full 6x6 inertia: j = (1 + e) v / (wA . K wA + 1/m). */
    @ParameterizedTest(name = "{0}, seed {1}")
    @MethodSource("hits")
    void aBallBouncesOffABodyWithTheWaterThatItCarries(Stepper stepper, long seed) {
        Draws draws = new Draws(seed);
        Quat turn = draws.orientation();
        Vec3 outward = turn.rotate(new Vec3(0, 0, 1));
        Vec3 contact = turn.rotate(new Vec3(0.3, -0.2, 0.5));
        Vec3 start = contact.plus(outward.times(0.1 + GAP));
        Vec3 velocity = outward.times(-SPEED);
        World world =
                collided(
                        stepper,
                        vehicle().orientation(turn).build(),
                        ball().position(start)
                                .velocity(velocity.x(), velocity.y(), velocity.z())
                                .build());
        double impulse = 2 * SPEED / (vehicleYields() + 1 / BALL);
        WorldObject ball = world.object("ball");
        WorldObject vehicle = world.object("vehicle");
        assertNear(ball.velocity(), outward.times(impulse / BALL - SPEED), 1e-9);
        assertNear(vehicle.linearMomentum(), outward.times(-impulse), 1e-9);
        Vec3 about =
                vehicle.angularMomentum().plus(vehicle.position().cross(vehicle.linearMomentum()));
        assertNear(about, contact.cross(outward.times(-impulse)), 1e-9);
        assertThat(energy(vehicle) + energy(ball))
                .isCloseTo(BALL * SPEED * SPEED / 2, within(1e-8));
    }

    private static final Vec3 CENTRE = new Vec3(0.1, -0.05, -0.2);

    private static WorldObjectDefinition.Builder vehicle() {
        return WorldObjectDefinition.named("vehicle")
                .volume(new Box(new Vec3(2, 1, 1)))
                .mass(10)
                .inertia(new Inertia(1, 2, 2.5, 0.1, -0.2, 0.3))
                .centreOfMass(CENTRE)
                .addedMass(
                        new AddedMass(
                                new Vec3(1, 5, 8),
                                new Vec3(0.2, 2, 3),
                                List.of(
                                        new AddedMassTerm(MotionAxis.SWAY, MotionAxis.YAW, 1.5),
                                        new AddedMassTerm(
                                                MotionAxis.HEAVE, MotionAxis.PITCH, -2))));
    }

    /** w . (MRB + MA)^-1 w for a push down on the box's top (Fossen 2021, equation 3.49). */
    private static double vehicleYields() {
        RealMatrix cross =
                new Array2DRowRealMatrix(
                        new double[][] {
                            {0, -CENTRE.z(), CENTRE.y()},
                            {CENTRE.z(), 0, -CENTRE.x()},
                            {-CENTRE.y(), CENTRE.x(), 0}
                        });
        RealMatrix about =
                new Array2DRowRealMatrix(
                                new double[][] {
                                    {1, 0.1, -0.2},
                                    {0.1, 2, 0.3},
                                    {-0.2, 0.3, 2.5}
                                })
                        .subtract(cross.multiply(cross).scalarMultiply(10));
        RealMatrix m = new Array2DRowRealMatrix(6, 6);
        m.setSubMatrix(new double[][] {{10, 0, 0}, {0, 10, 0}, {0, 0, 10}}, 0, 0);
        m.setSubMatrix(cross.scalarMultiply(-10).getData(), 0, 3);
        m.setSubMatrix(cross.scalarMultiply(10).getData(), 3, 0);
        m.setSubMatrix(about.getData(), 3, 3);
        double[] added = {1, 5, 8, 0.2, 2, 3};
        for (int k = 0; k < 6; k++) {
            m.addToEntry(k, k, added[k]);
        }
        m.addToEntry(1, 5, 1.5);
        m.addToEntry(5, 1, 1.5);
        m.addToEntry(2, 4, -2);
        m.addToEntry(4, 2, -2);
        Vec3 arm = new Vec3(0.3, -0.2, 0.5).cross(new Vec3(0, 0, 1));
        RealVector push = new ArrayRealVector(new double[] {0, 0, 1, arm.x(), arm.y(), arm.z()});
        return push.dotProduct(new LUDecomposition(m).getSolver().solve(push));
    }
}
