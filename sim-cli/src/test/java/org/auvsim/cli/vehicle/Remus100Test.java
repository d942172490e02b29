package org.auvsim.cli.vehicle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.cli.vehicle.Vehicles.advanceTo;
import static org.auvsim.cli.vehicle.Vehicles.remus;
import static org.auvsim.cli.vehicle.Vehicles.trial;

import org.auvsim.core.actuator.Fin;
import org.auvsim.core.entity.Held;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Optional;

/** The REMUS of the examples against what is published of it. */
class Remus100Test {
    private static final Held TO_A_LINE = new Held(false, true, true, true, true, true);
    private static final Held TO_A_PLANE = new Held(false, false, true, true, true, false);

    @Test
    void itsPublishedThrustDrivesItAtItsPublishedSpeed() throws Exception {
        World world = trial(remus(), Optional.of(TO_A_LINE), 0.5, _ -> 0);
        advanceTo(world, 200);

        double speed = world.objects().getFirst().velocity().x();
        assertThat(speed).isCloseTo(1.54, within(0.0154));
        assertThat(speed).isCloseTo(Math.sqrt(3.86 / 1.62), within(1e-6));
    }

    /** With fins instead of printed fin terms, and Munk's moment from the added mass. */
    @Test
    void fourDegreesOfRudderTurnItAsThePrintedSetDoes() throws Exception {
        double rudder = Math.toRadians(4);
        World world =
                trial(
                        remus(),
                        Optional.of(TO_A_PLANE),
                        1.54,
                        fin -> fin.name().endsWith("Rudder") ? rudder : 0);
        advanceTo(world, 60);
        PrintedRemus printed = new PrintedRemus(rudder, 0, true);
        for (int i = 0; i < 6000; i++) {
            printed.advance(0.01);
        }

        // To port: positive about z that points up, negative about the printed z.
        double rate = Math.toDegrees(world.objects().getFirst().angularVelocity().z());
        assertThat(rate).isCloseTo(9.1, within(0.3));
        assertThat(rate).isCloseTo(-Math.toDegrees(printed.state[PrintedRemus.R]), within(0.15));
        double faster = speedAhead(world.objects().getFirst()) / printed.state[PrintedRemus.U] - 1;
        assertThat(faster).isCloseTo(0.013, within(0.001));
    }

    private static double speedAhead(WorldObject body) {
        return body.orientation().rotateInverse(body.velocity()).x();
    }

    /** With fixed planes it is unstable, so that small differences grow. */
    @ParameterizedTest
    @ValueSource(doubles = {-8, -4, 4})
    void laterItPartsFromThePrintedSet(double degrees) throws Exception {
        double stern = Math.toRadians(degrees);
        World world = trial(remus(), Optional.empty(), 1.54, fin -> isPlane(fin) ? stern : 0);
        PrintedRemus printed = new PrintedRemus(0, stern, false);
        advanceTo(world, 20);
        for (int i = 0; i < 4000; i++) {
            printed.advance(0.005);
        }
        WorldObject body = world.objects().getFirst();
        double pitch = Math.asin(body.orientation().rotate(new Vec3(1, 0, 0)).z());
        double apart = Math.abs(Math.toDegrees(pitch - printed.state[PrintedRemus.PITCH]));
        double faster = speedAhead(body) / printed.state[PrintedRemus.U] - 1;
        assertThat(apart).isBetween(1.0, 5.0);
        assertThat(faster).isBetween(0.04, 0.15);
    }

    /** Free in all six directions; the planes go to their angle at once. */
    @ParameterizedTest
    @ValueSource(doubles = {-8, -4, 4})
    void aStepOfTheSternPlanesPitchesItAsThePrintedSetDoes(double degrees) throws Exception {
        double stern = Math.toRadians(degrees);
        World world = trial(remus(), Optional.empty(), 1.54, fin -> isPlane(fin) ? stern : 0);
        PrintedRemus printed = new PrintedRemus(0, stern, false);
        WorldObject body = world.objects().getFirst();
        double start = body.position().z();
        for (int second = 1; second <= 5; second++) {
            advanceTo(world, second);
            for (int i = 0; i < 200; i++) {
                printed.advance(0.005);
            }
            Quat attitude = body.orientation();
            double pitch = Math.asin(attitude.rotate(new Vec3(1, 0, 0)).z());
            double roll =
                    Math.atan2(
                            attitude.rotate(new Vec3(0, 1, 0)).z(),
                            attitude.rotate(new Vec3(0, 0, 1)).z());
            double[] s = printed.state;
            assertThat(Math.toDegrees(pitch))
                    .isCloseTo(Math.toDegrees(s[PrintedRemus.PITCH]), within(0.7));
            assertThat(Math.toDegrees(roll))
                    .isCloseTo(Math.toDegrees(s[PrintedRemus.ROLL]), within(0.5));
            assertThat(start - body.position().z()).isCloseTo(s[PrintedRemus.DEPTH], within(0.07));
        }
        assertThat(Math.abs(Math.toDegrees(printed.state[PrintedRemus.PITCH]))).isGreaterThan(5);
    }

    private static boolean isPlane(Fin fin) {
        return fin.name().endsWith("Plane");
    }
}
