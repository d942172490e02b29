package org.auvsim.core.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.AddedMass;
import org.auvsim.core.entity.AddedMassTerm;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.entity.CoupledEffect;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Held;
import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.MotionAxis;
import org.auvsim.core.entity.Mount;
import org.auvsim.core.entity.Pinned;
import org.auvsim.core.entity.Twist;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.entity.Wrench;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.Sphere;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

class ConstraintForceTest {
    private static final double G = 9.81;
    private static final double MASS = 10;
    private static final Vec3 CENTRE = new Vec3(0.1, -0.05, -0.2);
    private static final AddedMass WATER =
            new AddedMass(
                    new Vec3(1, 5, 8),
                    new Vec3(0.2, 2, 3),
                    List.of(
                            new AddedMassTerm(MotionAxis.SWAY, MotionAxis.YAW, 1.5),
                            new AddedMassTerm(MotionAxis.HEAVE, MotionAxis.PITCH, -2)));
    private static final Held COMPLETELY = new Held(true, true, true, true, true, true);

    /** A wrench that is there whatever the body does. */
    private record Pull(Wrench wrench) implements BodyEffect {
        @Override
        public void add(Block block, int i) {
            block.addForce(i, wrench.force());
            block.addTorque(i, wrench.torque());
        }
    }

    /** Water that moves unevenly, and in time. */
    private record Swirl(long id, String name) implements Current {
        @Override
        public Vec3 valueAt(Vec3 p, double t) {
            return new Vec3(
                    0.4 * StrictMath.sin(2 * t + 1) + 0.3 * p.y(),
                    0.5 * StrictMath.cos(3 * t) - 0.2 * p.x(),
                    0.1 * t + 0.4 * p.z());
        }
    }

    /** A line of a stiffness to the origin of another body. */
    private record Line(long to, double stiffness) implements CoupledEffect {
        @Override
        public List<Long> partners() {
            return List.of(to);
        }

        @Override
        public void add(Block block, int i, int[] partners) {
            Vec3 force = block.position(partners[0]).minus(block.position(i)).times(stiffness);
            block.addForce(i, force);
            block.addForce(partners[0], force.times(-1));
        }
    }

    private static WorldObjectDefinition.Builder body() {
        return WorldObjectDefinition.named("body")
                .id(1)
                .volume(new Box(new Vec3(1, 1, 1)))
                .mass(MASS)
                .inertia(new Inertia(1, 2, 2.5, 0.1, -0.2, 0.3));
    }

    private static WorldObjectDefinition.Builder vehicle() {
        return body().centreOfMass(CENTRE)
                .addedMass(WATER)
                .position(0.3, 0.7, -2)
                .orientation(new Quat(0.8, 0.1, -0.3, 0.5).normalized())
                .velocity(1, 0.5, -0.3)
                .angularVelocity(0.4, -0.3, 0.6)
                .effect(new Gravity(G))
                .effect(
                        new Damping(
                                new Vec3(5, 6, 7),
                                new Vec3(9, 8, 7),
                                new Vec3(1, 2, 3),
                                Vec3.ZERO));
    }

    private static World world(WorldObjectDefinition.Builder body) {
        return World.builder().add(body.build()).build();
    }

    private static void assertWrench(Wrench actual, Vec3 force, Vec3 torque, double tolerance) {
        assertNear(actual.force(), force, tolerance);
        assertNear(actual.torque(), torque, tolerance);
    }

    /** The pivot carries the weight and turns the centre of mass along its circle. */
    @Test
    void thePivotOfASwingingPendulumBearsWeightAndCentripetalForce() {
        Vec3 y = new Vec3(0, 1, 0);
        double length = 0.8;
        double angle = 0.7;
        double rate = 1.9;
        World world =
                world(
                        body().inertia(new Inertia(0.1, 0.3, 0.25, 0, 0, 0))
                                .mount(new Pinned(Optional.of(y)))
                                .centreOfMass(new Vec3(0, 0, -length))
                                .orientation(Quat.ofAxisAngle(y, angle))
                                .angularVelocity(0, rate, 0)
                                .effect(new Gravity(G)));
        double sin = StrictMath.sin(angle);
        double cos = StrictMath.cos(angle);
        Vec3 inward = new Vec3(sin, 0, cos);
        Vec3 forward = new Vec3(-cos, 0, sin);
        double acceleration = -MASS * G * length * sin / (0.3 + MASS * length * length);
        Vec3 ofCentre =
                inward.times(rate * rate * length).plus(forward.times(acceleration * length));
        Vec3 force = ofCentre.plus(new Vec3(0, 0, G)).times(MASS);
        assertWrench(world.constraintForce(1), force, Vec3.ZERO, 1e-12);
    }

    /** Products of inertia load the bearing of a rotor by w x (I w), its centre by m w^2 r. */
    @Test
    void theBearingOfAnUnbalancedRotorFeelsTheUnbalance() {
        double rate = 20;
        double ahead = 0.03;
        World world =
                world(
                        body().inertia(new Inertia(1, 2, 2.5, 0, -0.2, 0.3))
                                .centreOfMass(new Vec3(ahead, 0, 0))
                                .mount(new Pinned(Optional.of(new Vec3(0, 0, 2))))
                                .angularVelocity(0, 0, rate));
        assertWrench(
                world.constraintForce(1),
                new Vec3(-MASS * rate * rate * ahead, 0, 0),
                new Vec3(-0.3 * rate * rate, -0.2 * rate * rate, 0),
                1e-10);
    }

    /** A model on the carriage of a towing tank: its drag is what the tank measures. */
    @Test
    void theCarriageMeasuresWeightAndDragOfATowedModel() {
        World world =
                world(
                        body().centreOfMass(CENTRE)
                                .mount(COMPLETELY)
                                .effect(new Gravity(G))
                                .effect(
                                        new Damping(
                                                new Vec3(4, 5, 6),
                                                new Vec3(7, 8, 9),
                                                Vec3.ZERO,
                                                Vec3.ZERO)));
        world.add(new UniformCurrent(9, "stream", new Vec3(-1.5, 0.5, 0)));
        Vec3 drag = new Vec3(-(4 * 1.5 + 7 * 1.5 * 1.5), 5 * 0.5 + 8 * 0.5 * 0.5, 0);
        Vec3 weight = new Vec3(0, 0, -MASS * G);
        assertWrench(
                world.constraintForce(1),
                drag.plus(weight).times(-1),
                CENTRE.cross(weight).times(-1),
                1e-12);
    }

    /** Munk's moment: the water's momentum across the stream turns a body that is held in it. */
    @Test
    void aBodyHeldAskewInAStreamFeelsMunksMoment() {
        AddedMass slender = new AddedMass(new Vec3(1, 30, 30), Vec3.ZERO, List.of());
        World world = world(body().addedMass(slender).mount(COMPLETELY));
        world.add(new UniformCurrent(9, "stream", new Vec3(2, 0.5, 0)));
        Vec3 moment = new Vec3(0, 0, (30 - 1) * 2 * 0.5);
        assertWrench(world.constraintForce(1), Vec3.ZERO, moment, 1e-12);
    }

    static Stream<Mount> mounts() {
        return Stream.of(
                new Pinned(Optional.empty()),
                new Pinned(Optional.of(new Vec3(1, 2, -1))),
                new Held(false, false, true, true, true, false),
                new Held(true, false, false, false, true, false),
                COMPLETELY);
    }

    @ParameterizedTest
    @MethodSource("mounts")
    void theWrenchInPlaceOfTheMountGivesTheSameMotion(Mount mount) {
        World held = world(vehicle().mount(mount));
        held.add(new Swirl(9, "swirl"));
        Twist start = held.object(1).twist();
        Wrench wrench = held.constraintForce(1);
        World free = world(vehicle().effect(new Pull(wrench)));
        free.add(new Swirl(9, "swirl"));
        free.object(1).setVelocity(start.velocity());
        free.object(1).setAngularVelocity(start.angularVelocity());
        double dt = 1e-5;
        held.advanceTimestep(dt);
        free.advanceTimestep(dt);
        Twist afterHeld = held.object(1).twist();
        Twist afterFree = free.object(1).twist();
        assertThat(wrench.force().norm() + wrench.torque().norm()).isGreaterThan(1);
        assertNear(afterFree.velocity(), afterHeld.velocity(), 1e-9);
        assertNear(afterFree.angularVelocity(), afterHeld.angularVelocity(), 1e-9);
    }

    @Test
    void aMooringFeelsWhatHangsOnIt() {
        World world =
                World.builder()
                        .add(ball("buoy", 1, new Vec3(0, 3, 4)).effect(new Line(2, 5)).build())
                        .add(ball("anchor", 2, Vec3.ZERO).fixed().build())
                        .add(ball("other", 3, new Vec3(7, 0, 0)).effect(new Line(2, 2)).build())
                        .build();
        Vec3 pull = new Vec3(14, 15, 20);
        assertWrench(world.constraintForce(2), pull.times(-1), Vec3.ZERO, 1e-12);
        assertThat(world.constraintForce(1)).isEqualTo(Wrench.ZERO);
    }

    private static WorldObjectDefinition.Builder ball(String name, long id, Vec3 position) {
        return WorldObjectDefinition.named(name)
                .id(id)
                .volume(new Sphere(0.5))
                .mass(1)
                .position(position);
    }

    @Test
    void nobodyHoldsWhatIsNotThere() {
        World world = world(body());
        assertThatThrownBy(() -> world.constraintForce(7))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("7");
    }
}
