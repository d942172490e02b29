package org.auvsim.viz.driving;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.message.control.ApplyDirectForceCommand;
import org.auvsim.auvsml.message.control.RemoveForceCommand;
import org.auvsim.auvsml.message.control.SetPropulsorCommand;
import org.auvsim.core.actuator.Fin;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.viz.scene.Movement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.Map;
import java.util.Optional;

class DrivingTest {
    private static final int SURGE = 0;
    private static final int PITCH = 4;
    private static final boolean AHEAD = false;
    private static final boolean ASTERN = true;

    @ParameterizedTest
    @CsvSource({"1, 0, 0, 0", "0, 1, 0, 0", "0, 0, 1, 0", "0, 0, 0, 1", "-0.4, 0, 0, 0"})
    void anRovPushesThereAloneWhereItIsAskedTo(double surge, double sway, double heave, double yaw)
            throws Exception {
        WorldObjectDefinition rov = Examples.first("bluerov2-dive.xml");
        Orders orders = new Driving(rov).orders(new Wanted(surge, sway, heave, yaw, 0), AHEAD);
        double[] wrench = wrench(rov, orders);
        double[] wanted = {surge, sway, heave, 0, 0, yaw};
        for (int axis = 0; axis < 6; axis++) {
            if (wanted[axis] == 0) {
                assertThat(wrench[axis]).as("axis " + axis).isCloseTo(0, within(0.3));
            } else {
                assertThat(wrench[axis] * Math.signum(wanted[axis])).isGreaterThan(3);
            }
        }
    }

    @Test
    void whatIsTooMuchIsLessenedAlike() throws Exception {
        WorldObjectDefinition rov = Examples.first("bluerov2-dive.xml");
        Driving driving = new Driving(rov);
        Orders orders = driving.orders(new Wanted(1, 1, 1, 1, 0), AHEAD);
        assertThat(orders.levels().values()).allMatch(level -> Math.abs(level) <= 1);
        double[] much = wrench(rov, orders);
        double[] little = wrench(rov, driving.orders(new Wanted(0.2, 0.2, 0.2, 0.2, 0), AHEAD));
        for (int axis : new int[] {0, 1, 2, 5}) {
            assertThat(much[axis] / much[SURGE])
                    .isCloseTo(little[axis] / little[SURGE], within(0.02));
        }
    }

    @Test
    void aTorpedoTurnsItsRuddersToPort() throws Exception {
        WorldObjectDefinition torpedo = Examples.first("remus-turn.xml");
        Orders orders = new Driving(torpedo).orders(new Wanted(1, 0, 0, 1, 0), AHEAD);
        assertThat(orders.levels().get("Propeller")).isCloseTo(1, within(0.01));
        // The scenario turns to port with positive angles of both.
        assertThat(orders.angles().get("Upper Rudder")).isCloseTo(0.35, within(0.01));
        assertThat(orders.angles().get("Lower Rudder")).isCloseTo(0.35, within(0.01));
        assertThat(orders.angles().get("Port Stern Plane")).isZero();
    }

    @Test
    void goingAsternATorpedoTurnsItsFinsTheOtherWay() throws Exception {
        Driving torpedo = new Driving(Examples.first("remus-turn.xml"));
        Wanted wanted = new Wanted(-1, 0, 0, 1, 0.5);
        Orders ahead = torpedo.orders(wanted, AHEAD);
        Orders astern = torpedo.orders(wanted, ASTERN);
        assertThat(astern.angles().get("Upper Rudder")).isCloseTo(-0.35, within(0.01));
        astern.angles()
                .forEach(
                        (fin, angle) ->
                                assertThat(-angle)
                                        .as(fin)
                                        .isEqualTo(ahead.angles().getOrDefault(fin, Double.NaN)));
        assertThat(astern.levels()).isEqualTo(ahead.levels());
    }

    @Test
    void theLiftOfAFinThatGoesAsternTurnsAsItIsAskedTo() throws Exception {
        for (boolean isAstern : new boolean[] {AHEAD, ASTERN}) {
            World world =
                    World.builder()
                            .timeStep(0.01)
                            .add(steered(isAstern ? -1.5 : 1.5, isAstern))
                            .build();
            for (int step = 0; step < 50; step++) {
                world.advanceTimestep();
            }
            assertThat(world.object(1).angularVelocity().z()).isPositive();
        }
    }

    /** The torpedo of an example at a speed (m/s), its fins so that it should turn to port. */
    private static WorldObjectDefinition steered(double surge, boolean isAstern) throws Exception {
        WorldObjectDefinition torpedo = Examples.first("remus-turn.xml");
        Orders orders = new Driving(torpedo).orders(new Wanted(0, 0, 0, 1, 0), isAstern);
        return torpedo.toBuilder()
                .id(1)
                .velocity(surge, 0, 0)
                .components(
                        torpedo.component().stream()
                                .filter(Fin.class::isInstance)
                                .map(Fin.class::cast)
                                .<Component>map(
                                        fin ->
                                                fin.commanded(
                                                        orders.angles()
                                                                .getOrDefault(fin.name(), 0.0),
                                                        0))
                                .toList())
                .build();
    }

    @Test
    void whatGoesAsternIsToldByTheWaterAndKeptWhileItHardlyMoves() {
        Way way = new Way();
        way.see(moving(0.5), new Vec3(0.8, 0, 0));
        assertThat(way.isAstern()).isTrue();
        way.see(moving(Way.CREEP / 2), Vec3.ZERO);
        assertThat(way.isAstern()).isTrue();
        way.see(moving(0.5), Vec3.ZERO);
        assertThat(way.isAstern()).isFalse();
    }

    private static Movement moving(double surge) {
        return new Movement(0, Vec3.ZERO, Quat.IDENTITY, new Vec3(surge, 0, 0), Vec3.ZERO);
    }

    @Test
    void aTorpedoLiftsItsBowByItsSternPlanes() throws Exception {
        WorldObjectDefinition torpedo = Examples.first("remus-turn.xml");
        Orders orders = new Driving(torpedo).orders(new Wanted(0, 0, 0, 0, 0.5), AHEAD);
        Fin plane = fin(torpedo, "Port Stern Plane");
        double angle = orders.angles().getOrDefault("Port Stern Plane", Double.NaN);
        Vec3 lift = plane.span().cross(new Vec3(1, 0, 0)).times(angle);
        // About +y the bow goes down.
        assertThat(plane.position().cross(lift).y()).isNegative();
        assertThat(orders.angles().get("Upper Rudder")).isZero();
    }

    @Test
    void ruddersOnOppositeSpansTurnOppositely() {
        WorldObjectDefinition body =
                WorldObjectDefinition.named("Glider")
                        .mass(10)
                        .volume(new Sphere(1))
                        .component(rudder("up", new Vec3(0, 0, 1)))
                        .component(rudder("down", new Vec3(0, 0, -1)))
                        .build();
        Orders orders = new Driving(body).orders(new Wanted(0, 0, 0, -1, 0), AHEAD);
        assertThat(orders.angles().get("up"))
                .isEqualTo(-orders.angles().getOrDefault("down", Double.NaN));
        assertThat(orders.angles().get("up")).isPositive();
    }

    @Test
    void whatHasNoPropulsorIsPushedByAForceUntilItIsLetGo() {
        WorldObjectDefinition body =
                WorldObjectDefinition.named("Ball").mass(20).volume(new Sphere(1)).build();
        Driving driving = new Driving(body);
        Orders push = driving.orders(new Wanted(0.5, 0, -1, 1, 0), AHEAD);
        assertThat(push.since(Orders.NONE, 7))
                .containsExactly(
                        new ApplyDirectForceCommand(7, "Viewer", Frame.BODY, new Vec3(10, 0, -20)));
        assertThat(driving.orders(Wanted.NOTHING, AHEAD).since(push, 7))
                .containsExactly(new RemoveForceCommand(7, "Viewer"));
    }

    @Test
    void onlyWhatDiffersIsSent() {
        Orders before = new Orders(Map.of("a", 1.0, "b", 0.5), Map.of(), Optional.empty());
        Orders now = new Orders(Map.of("a", 1.0, "b", 0.25), Map.of(), Optional.empty());
        assertThat(now.since(before, 3)).containsExactly(new SetPropulsorCommand(3, "b", 0.25));
    }

    @Test
    void whatIsFixedCannotBeDriven() {
        WorldObjectDefinition rock =
                WorldObjectDefinition.named("Rock").fixed().volume(new Sphere(1)).build();
        assertThat(new Driving(rock).isPossible()).isFalse();
    }

    private static Fin rudder(String name, Vec3 span) {
        return new Fin(
                name,
                0.01,
                3,
                new Vec3(-1, 0, 0),
                new Vec3(1, 0, 0),
                span,
                0,
                0,
                0.35,
                1025,
                0,
                0,
                0.3,
                java.util.OptionalDouble.empty(),
                Optional.empty());
    }

    private static Fin fin(WorldObjectDefinition of, String name) {
        return of.component().stream()
                .filter(c -> c.name().equals(name))
                .map(Fin.class::cast)
                .findFirst()
                .orElseThrow();
    }

    /** Force and torque about the centre of mass that orders bring, by the propulsors' own word. */
    private static double[] wrench(WorldObjectDefinition of, Orders orders) {
        double[] sum = new double[6];
        of.component().stream()
                .filter(Propulsor.class::isInstance)
                .map(Propulsor.class::cast)
                .forEach(
                        p -> {
                            double level = orders.levels().getOrDefault(p.name(), Double.NaN);
                            Vec3 force = p.direction().times(p.commanded(level, 0).thrustAt(1e6));
                            Vec3 torque = p.position().cross(force);
                            sum[0] += force.x();
                            sum[1] += force.y();
                            sum[2] += force.z();
                            sum[3] += torque.x();
                            sum[PITCH] += torque.y();
                            sum[5] += torque.z();
                        });
        return sum;
    }
}
