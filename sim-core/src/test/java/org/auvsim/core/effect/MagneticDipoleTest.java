package org.auvsim.core.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.MagneticDipoleField;
import org.auvsim.core.field.UniformMagneticField;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;

class MagneticDipoleTest {
    private static WorldObjectDefinition.Builder magnet(Vec3 moment) {
        return WorldObjectDefinition.named("magnet")
                .volume(new Sphere(0.1))
                .mass(2)
                .inertia(new Inertia(0.5, 0.5, 0.5, 0, 0, 0))
                .effect(new MagneticDipole(moment));
    }

    /** A needle swings about the field at the rate sqrt(m B / I) while its angle is small. */
    @Test
    void aNeedleSwingsAboutTheField() {
        World world =
                World.builder()
                        .timeStep(0.01)
                        .add(new UniformMagneticField(1, "earth", new Vec3(0, 5e-5, 0)))
                        .add(magnet(new Vec3(4e4 * 1e-4, 4e4, 0)).build())
                        .build();
        double rate = Math.sqrt(4e4 * 5e-5 / 0.5);
        while (world.time() < 3) {
            world.advanceTimestep();
        }
        // The moment leads by 1e-4 rad at first: the body's angle is the swing less that.
        assertThat(world.object("magnet").orientation().rotate(new Vec3(1, 0, 0)).y())
                .isCloseTo(1e-4 - 1e-4 * StrictMath.cos(rate * world.time()), within(1e-9));
        assertThat(world.object("magnet").linearMomentum()).isEqualTo(Vec3.ZERO);
    }

    /** Two dipoles in line attract with 3 mu0 m1 m2 / (2 pi r^4). */
    @Test
    void magnetsInLineAttractAsTheTextbookSays() {
        World world =
                World.builder()
                        .timeStep(1e-4)
                        .add(
                                new MagneticDipoleField(
                                        1, "wreck", new Vec3(0, 0, -3), new Vec3(0, 0, 1e4), 1))
                        .add(magnet(new Vec3(0, 0, 500)).build())
                        .build();
        world.advanceTimestep();
        double force = 6e-7 * 1e4 * 500 / 81;
        Vec3 momentum = world.object("magnet").linearMomentum();
        assertNear(momentum.times(1 / world.time()), new Vec3(0, 0, -force), 1e-9);
    }

    /** Kinetic energy and -m . B together do not change. */
    @Test
    void aMagnetNearAWreckKeepsItsEnergy() {
        MagneticDipoleField wreck =
                new MagneticDipoleField(1, "wreck", Vec3.ZERO, new Vec3(3e5, 0, 1e5), 0.2);
        World world =
                World.builder()
                        .timeStep(0.002)
                        .add(wreck)
                        .add(magnet(new Vec3(100, 200, 300)).position(0, 2, 1).build())
                        .build();
        WorldObject body = world.object("magnet");
        double before = energy(body, wreck);
        double most = 0;
        while (world.time() < 1) {
            world.advanceTimestep();
            assertThat(energy(body, wreck)).isCloseTo(before, within(1e-6));
            most = Math.max(most, body.velocity().norm());
        }
        assertThat(most).isGreaterThan(0.05);
    }

    private static double energy(WorldObject body, MagneticDipoleField field) {
        Vec3 moment = body.orientation().rotate(new Vec3(100, 200, 300));
        return (body.linearMomentum().dot(body.velocity())
                                + body.angularMomentum().dot(body.angularVelocity()))
                        / 2
                - moment.dot(field.valueAt(body.position(), 0));
    }

    @Test
    void aMomentIsFinite() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new MagneticDipole(new Vec3(0, Double.NaN, 0)))
                .withMessageContaining("the moment of a magnetic dipole must be finite");
    }
}
