package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Coulomb friction on a slope, against the textbook. */
class FrictionTest {
    /** A block that lies on a slope which falls toward +x. */
    private static World block(double angle, double friction) {
        Vec3 normal = new Vec3(StrictMath.sin(angle), 0, StrictMath.cos(angle));
        return World.builder()
                .stepper(EventStepper.standard())
                .add(Ground.plane("Slope", Vec3.ZERO, normal, friction))
                .add(
                        Ground.heavy("Block", new Box(new Vec3(1, 1, 0.4)))
                                .restitution(0)
                                .friction(friction)
                                .position(normal.times(0.2))
                                .orientation(Ground.turnFromZ(normal))
                                .build())
                .build();
    }

    @ParameterizedTest(name = "friction {0}, {1} of the angle at which it slides")
    @CsvSource({"0.3, 0.5", "0.3, 0.98", "0.8, 0.98", "1.2, 0.5"})
    void belowTheAngleOfFrictionABlockStays(double friction, double share) {
        World world = block(StrictMath.atan(friction) * share, friction);
        Vec3 before = world.object("Block").position();

        Ground.run(world, 10);

        assertThat(world.object("Block").position().distance(before)).isLessThan(1e-3);
        assertThat(world.object("Block").velocity().norm()).isLessThan(1e-6);
    }

    @ParameterizedTest(name = "friction {0}, {1} rad")
    @CsvSource({"0, 0.3", "0.3, 0.35", "0.3, 0.6", "0.5, 0.7"})
    void aboveItSlidesWithWhatIsLeftOfItsWeight(double friction, double angle) {
        World world = block(angle, friction);
        Vec3 before = world.object("Block").position();

        Ground.run(world, 1.5);

        double a = Ground.G * (StrictMath.sin(angle) - friction * StrictMath.cos(angle));
        double t = world.time();
        Vec3 down = new Vec3(StrictMath.cos(angle), 0, -StrictMath.sin(angle));
        Vec3 way = world.object("Block").position().minus(before);
        assertThat(world.object("Block").velocity().dot(down)).isEqualTo(a * t, within(1e-2 * a));
        assertThat(way.dot(down)).isEqualTo(a * t * t / 2, within(1e-2 * a));
        assertThat(way.minus(down.times(way.dot(down))).norm()).isLessThan(1e-4);
    }

    /** Without slipping it gains 5/7 of what it would gain sliding freely. */
    @ParameterizedTest(name = "{0} rad")
    @CsvSource({"0.1", "0.3"})
    void aBallRollsDown(double angle) {
        Vec3 normal = new Vec3(StrictMath.sin(angle), 0, StrictMath.cos(angle));
        World world =
                World.builder()
                        .stepper(EventStepper.standard())
                        .add(Ground.plane("Slope", Vec3.ZERO, normal, 1))
                        .add(
                                Ground.heavy("Ball", new Sphere(0.5))
                                        .restitution(0)
                                        .friction(1)
                                        .position(normal.times(0.5))
                                        .build())
                        .build();

        Ground.run(world, 2);

        double speed = 5.0 / 7 * Ground.G * StrictMath.sin(angle) * world.time();
        assertThat(world.object("Ball").velocity().norm()).isEqualTo(speed, within(0.01 * speed));
        assertThat(world.object("Ball").angularVelocity().y())
                .isEqualTo(speed / 0.5, within(0.02 * speed));
    }
}
