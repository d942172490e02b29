package org.auvsim.core.actuator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.Pinned;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.entity.Wrench;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Optional;
import java.util.OptionalDouble;

class FinTest {
    private static final double AREA = 0.02;
    private static final double SLOPE = 3;
    private static final double DENSITY = 1000;
    private static final double STALL = 0.3;
    private static final Vec3 UP = new Vec3(0, 0, 1);

    private static Fin fin(Vec3 place, Vec3 span, double angle, double drag, double induced) {
        return new Fin(
                "rudder",
                AREA,
                SLOPE,
                place,
                new Vec3(1, 0, 0),
                span,
                drag,
                induced,
                STALL,
                DENSITY,
                0,
                angle,
                Math.PI,
                OptionalDouble.empty(),
                Optional.empty());
    }

    /** Force and torque of a fin on a body that is held, with the water streaming past. */
    private static Wrench exerted(Fin fin, Vec3 water) {
        World world =
                World.builder()
                        .add(new UniformCurrent(9, "stream", water))
                        .add(
                                WorldObjectDefinition.named("body")
                                        .id(1)
                                        .mass(1)
                                        .volume(new Sphere(0.1))
                                        .inertia(new Inertia(1e6, 1e6, 1e6, 0, 0, 0))
                                        .mount(new Pinned(Optional.empty()))
                                        .component(fin)
                                        .build())
                        .build();
        double step = 1e-7;
        Vec3 force = world.constraintForce(1).force().negated();
        world.advanceTimestep(step);
        return new Wrench(force, world.object(1).angularMomentum().times(1 / step));
    }

    @Test
    void attachedFlowLiftsInProportionToTheAngleOfAttack() {
        Wrench push = exerted(fin(new Vec3(-0.5, 0, 0), UP, 0.1, 0.02, 0.2), new Vec3(-2, 0, 0));

        double dynamic = 0.5 * DENSITY * 4 * AREA;
        double lift = dynamic * SLOPE * 0.1;
        double drag = dynamic * (0.02 + 0.2 * (SLOPE * 0.1) * (SLOPE * 0.1));
        assertNear(push.force(), new Vec3(-drag, lift, 0), 1e-12);
        assertNear(push.torque(), new Vec3(0, 0, -0.5 * lift), 1e-4);
    }

    @Test
    void theRaceOfAPropellerIsFasterWater() {
        Fin fin = fin(new Vec3(-0.5, 0, 0), UP, 0.1, 0.02, 0.2);
        Wrench inRace = exerted(fin.inRace(1.5), new Vec3(-0.5, 0.1, 0));

        Wrench inFasterWater = exerted(fin, new Vec3(-2, 0.1, 0));
        assertNear(inRace.force(), inFasterWater.force(), 1e-12);
        assertNear(inRace.torque(), inFasterWater.torque(), 1e-4);
    }

    @Test
    void aFinOfTwiceTheAreaPushesTwiceAsHard() {
        Fin fin = fin(Vec3.ZERO, UP, 0.1, 0.02, 0.2);
        Vec3 water = new Vec3(-2, 0.1, 0);

        assertNear(
                exerted(fin.sized(2 * AREA), water).force(),
                exerted(fin, water).force().times(2),
                1e-12);
    }

    @Test
    void aFlowFromAsideLiftsLikeADeflection() {
        double attack = 0.12;
        Vec3 water = new Vec3(-Math.cos(attack), Math.sin(attack), 0).times(3);
        Wrench push = exerted(fin(Vec3.ZERO, UP, 0, 0, 0), water);

        double lift = 0.5 * DENSITY * 9 * AREA * SLOPE * attack;
        Vec3 square = new Vec3(Math.sin(attack), Math.cos(attack), 0);
        assertNear(push.force(), square.times(lift), 1e-10);
    }

    @Test
    void whatFlowsAlongTheSpanDoesNothing() {
        Wrench push = exerted(fin(Vec3.ZERO, UP, 0.2, 0.1, 0.1), new Vec3(0, 0, 5));

        assertThat(push.force().norm()).isZero();
    }

    @Test
    void aStalledFinIsAFlatPlate() {
        double pressure = 0.5 * DENSITY * 4 * AREA;
        Wrench across = exerted(fin(Vec3.ZERO, UP, Math.PI / 2, 0.05, 0), new Vec3(-2, 0, 0));
        Wrench beyond = exerted(fin(Vec3.ZERO, UP, 1, 0, 0), new Vec3(-2, 0, 0));

        assertNear(across.force(), new Vec3(-2.05 * pressure, 0, 0), 1e-10);
        assertNear(
                beyond.force(),
                new Vec3(-2 * Math.sin(1) * Math.sin(1), 2 * Math.sin(1) * Math.cos(1), 0)
                        .times(pressure),
                1e-10);
    }

    @Test
    void liftHasNoStepWhereTheFlowSeparates() {
        double before = exerted(fin(Vec3.ZERO, UP, 0, 0, 0), new Vec3(-1, 0, 0)).force().y();
        double steepest = 0.5 * DENSITY * AREA * 2 * SLOPE;
        for (double angle = 0.005; angle < Math.PI; angle += 0.005) {
            double lift = exerted(fin(Vec3.ZERO, UP, angle, 0, 0), new Vec3(-1, 0, 0)).force().y();
            assertThat(lift).isCloseTo(before, within(0.005 * steepest));
            before = lift;
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4})
    void aFixedFinNeverAddsEnergyInStillWater(long seed) {
        Draws draws = new Draws(seed);
        for (int k = 0; k < 50; k++) {
            Vec3 velocity = draws.vector(3);
            Vec3 turn = draws.vector(3);
            Fin fin = fin(draws.vector(1), draws.vector(1), draws.vector(3).x(), 0.01, 0.1);
            World world =
                    World.builder()
                            .add(
                                    WorldObjectDefinition.named("body")
                                            .mass(2)
                                            .volume(new Sphere(0.3))
                                            .velocity(velocity.x(), velocity.y(), velocity.z())
                                            .angularVelocity(turn.x(), turn.y(), turn.z())
                                            .component(fin)
                                            .build())
                            .build();
            WorldObject body = world.objects().getFirst();
            double before = energy(body);
            world.advanceTimestep(1e-4);

            assertThat(energy(body)).isLessThan(before);
        }
    }

    private static double energy(WorldObject body) {
        return (body.linearMomentum().dot(body.velocity())
                        + body.angularMomentum().dot(body.angularVelocity()))
                / 2;
    }

    /** A vane on a pivot: I a'' + k l (U l) a' + k U^2 l a = 0 with k = rho A slope / 2. */
    @Test
    void aVaneSwingsAsADampedPendulum() {
        double stream = 1.5;
        double arm = 0.8;
        double inertia = 6;
        double start = 1e-4;
        double step = 0.01;
        World world =
                World.builder()
                        .timeStep(step)
                        .add(new UniformCurrent(9, "stream", new Vec3(-stream, 0, 0)))
                        .add(
                                WorldObjectDefinition.named("vane")
                                        .mass(5)
                                        .volume(new Sphere(0.1))
                                        .inertia(new Inertia(inertia, inertia, inertia, 0, 0, 0))
                                        .mount(new Pinned(Optional.of(UP)))
                                        .orientation(
                                                new Quat(
                                                        Math.cos(start / 2),
                                                        0,
                                                        0,
                                                        Math.sin(start / 2)))
                                        .component(fin(new Vec3(-arm, 0, 0), UP, 0, 0, 0))
                                        .build())
                        .build();
        double k = 0.5 * DENSITY * AREA * SLOPE;
        double decay = k * stream * arm * arm / inertia / 2;
        double swing = Math.sqrt(k * stream * stream * arm / inertia - decay * decay);
        WorldObject vane = world.object("vane");
        for (int i = 0; i < 300; i++) {
            world.advanceTimestep();
            double t = world.time();
            double expected =
                    start
                            * Math.exp(-decay * t)
                            * (Math.cos(swing * t) + decay / swing * Math.sin(swing * t));
            assertThat(2 * vane.orientation().z()).isCloseTo(expected, within(1e-6 * start));
        }
    }

    @Test
    void aFinTurnsWithItsMaximumRate() {
        Fin quick = fin(Vec3.ZERO, UP, 0, 0, 0);
        Fin slow =
                new Fin(
                        "rudder",
                        AREA,
                        SLOPE,
                        Vec3.ZERO,
                        new Vec3(1, 0, 0),
                        UP,
                        0,
                        0,
                        STALL,
                        DENSITY,
                        0,
                        0,
                        0.4,
                        OptionalDouble.of(0.5),
                        Optional.empty());

        assertThat(quick.commanded(0.3, 1).angleAt(1)).isEqualTo(0.3);
        Fin steered = slow.commanded(0.3, 1);
        assertThat(steered.angleAt(1.2)).isCloseTo(0.1, within(1e-15));
        assertThat(steered.angleAt(1.6)).isEqualTo(0.3);
        Fin back = steered.commanded(-0.4, 1.2);
        assertThat(back.angleAt(1.4)).isCloseTo(0, within(1e-15));
        assertThat(back.angleAt(3)).isEqualTo(-0.4);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> slow.commanded(0.5, 0))
                .withMessage("the angle of fin 'rudder' must be -0.4 to 0.4 rad, but is 0.5 rad");
    }

    @Test
    void aFinOutsideItsDomainIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> fin(Vec3.ZERO, UP, 0, -0.1, 0))
                .withMessage(
                        "the drag coefficient of fin 'rudder' must be 0 or more and finite, but is"
                                + " -0.1");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> fin(Vec3.ZERO, new Vec3(2, 0, 0), 0, 0, 0))
                .withMessage(
                        "chord and span of fin 'rudder' must be across each other, but are"
                                + " (1.0, 0.0, 0.0) and (2.0, 0.0, 0.0)");
    }
}
