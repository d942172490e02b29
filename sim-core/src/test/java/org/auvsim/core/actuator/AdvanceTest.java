package org.auvsim.core.actuator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.actuator.Screws.MASS;
import static org.auvsim.core.actuator.Screws.THRUST;
import static org.auvsim.core.actuator.Screws.advance;
import static org.auvsim.core.actuator.Screws.body;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A screw that bites less, the faster it goes ahead. */
class AdvanceTest {
    private static final double LOSS = 0.4;
    private static final Vec3 AHEAD = new Vec3(1, 0, 0);

    private static Propulsor screw(String name, double level, Vec3 at, Vec3 towards) {
        return new Propulsor(name, THRUST, level, at, towards).advancing(LOSS);
    }

    private static WorldObjectDefinition.Builder withScrew(double level, Vec3 towards) {
        return WorldObjectDefinition.named("body")
                .mass(MASS)
                .volume(new Sphere(0.2))
                .component(screw("screw", level, Vec3.ZERO, towards));
    }

    /**
     * m dv/dt = T - loss sqrt(|T| T_max) v, whose solution is an exponential, ahead and astern, to
     * wherever the body's nose points and whatever its speed at first.
     */
    @ParameterizedTest
    @CsvSource({"1, 0, 0", "0.25, 0, 0", "-0.25, 0, 0", "-0.5, 1.5, 0", "0.6, -1, 0", "0.6, 1, 2"})
    void comesToTheSpeedAtWhichItPushesNoMore(double level, double before, double current) {
        Quat turned = Quat.ofAxisAngle(new Vec3(1, 2, -3), 0.8);
        Vec3 towards = new Vec3(0, 0.6, 0.8);
        Vec3 ahead = turned.rotate(towards);
        World world =
                World.builder()
                        .timeStep(0.01)
                        .add(new UniformCurrent(2, "stream", ahead.times(current)))
                        .add(
                                withScrew(level, towards)
                                        .orientation(turned)
                                        .velocity(
                                                before * ahead.x(),
                                                before * ahead.y(),
                                                before * ahead.z())
                                        .build())
                        .build();

        advance(world, 200);

        double revolutions = Math.sqrt(Math.abs(level));
        double end = current + Math.signum(level) * revolutions / LOSS;
        double left = Math.exp(-LOSS * revolutions * THRUST / MASS * world.time());
        assertNear(body(world).velocity(), ahead.times(end + (before - end) * left), 1e-9);
    }

    /** Two that turn a body without moving it: J dw/dt = 2 r T (1 - loss r w). */
    @Test
    void goesAheadByTheTurningOfItsBodyToo() {
        double arm = 0.5;
        double inertia = 2;
        World world =
                World.builder()
                        .timeStep(0.01)
                        .add(
                                WorldObjectDefinition.named("body")
                                        .mass(MASS)
                                        .inertia(new Inertia(3, 4, inertia, 0, 0, 0))
                                        .volume(new Sphere(0.2))
                                        .component(
                                                screw(
                                                        "port",
                                                        1,
                                                        new Vec3(0, arm, 0),
                                                        AHEAD.times(-1)))
                                        .component(
                                                screw("starboard", 1, new Vec3(0, -arm, 0), AHEAD))
                                        .build())
                        .build();

        advance(world, 30);

        double rate = 2 * arm * arm * LOSS * THRUST / inertia;
        double turning = (1 - Math.exp(-rate * world.time())) / (LOSS * arm);
        assertNear(body(world).angularVelocity(), new Vec3(0, 0, turning), 1e-9);
    }

    @Test
    void aWornOneLosesByTheSameShare() {
        Propulsor worn = screw("screw", 1, Vec3.ZERO, AHEAD).in(Condition.SOUND.gaining(0.5));
        World world = Screws.world(worn);

        advance(world, 400);

        assertThat(body(world).velocity().x()).isCloseTo(1 / LOSS, within(1e-3));
        assertThat(Screws.screw(world).thrustAt(0)).isEqualTo(0.5 * THRUST);
    }

    @Test
    void oneThatPushesMoreBySpeedIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Screws.plain(1).advancing(-0.1))
                .withMessage(
                        "the advance loss of propulsor 'screw' must be 0 s/m or more and finite,"
                                + " but is -0.1 s/m");
    }
}
