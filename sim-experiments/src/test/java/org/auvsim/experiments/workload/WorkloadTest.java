package org.auvsim.experiments.workload;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.effect.CentralForce;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class WorkloadTest {
    private static World world(int bodies) {
        return Workload.of(bodies).world().build();
    }

    @Test
    void aClusterIsALatticeAboutItsOrigin() {
        World world = world(100);
        Vec3 sum = Vec3.ZERO;
        for (WorldObject object : world.objects().subList(0, 25)) {
            sum = sum.plus(object.position());
        }

        assertThat(world.objects()).hasSize(100);
        Vec3 first = world.object("Sphere 1").position();
        assertThat(first.distance(new Vec3(-12, -12, -12))).isBetween(1e-9, 2e-6);
        assertThat(world.object("Sphere 2").position().minus(first).x()).isEqualTo(6, within(1e-5));
        assertThat(world.object("Sphere 6").position().minus(first).y()).isEqualTo(6, within(1e-5));
        // One full layer of z.
        assertThat(sum.times(1.0 / 25).distance(new Vec3(0, 0, -12))).isLessThan(1e-5);
    }

    @Test
    void targetsStandOnASphereOfTwoMetres() {
        for (WorldObject object : world(150).objects().subList(0, 100)) {
            assertThat(drive(object).target().norm()).isEqualTo(2, within(1e-9));
            assertThat(drive(object).force()).isEqualTo(10);
        }
    }

    /** Body 25 of 100: u = -1/2, s = sqrt 3/2, and 25 golden angles are 59.999075. */
    @Test
    void aTargetIsAPointOfTheSpiral() {
        Vec3 target = drive(world(100).object(26)).target();

        assertThat(target.z()).isEqualTo(-1);
        double s = Math.sqrt(3);
        Vec3 expected = new Vec3(s * Math.cos(59.999075), s * Math.sin(59.999075), -1);
        assertThat(target.distance(expected)).isLessThan(1e-12);
    }

    @Test
    void aCommonTargetIsTheOrigin() {
        World world = Workload.of(30).withTargets(Targets.COMMON).world().build();
        assertThat(world.objects()).allMatch(o -> drive(o).target().equals(Vec3.ZERO));
    }

    @Test
    void clustersAreSixtyMetresApart() {
        World world = world(901);

        assertThat(between(world, 1, 101)).isEqualTo(new Vec3(60, 0, 0));
        assertThat(between(world, 1, 301)).isEqualTo(new Vec3(0, 60, 0));
        // The tenth cluster, of one body whose target is the spiral's first point.
        assertThat(drive(world.object(901)).target().distance(new Vec3(0, 0, 58))).isLessThan(1e-9);
    }

    private static Vec3 between(World world, long a, long b) {
        return drive(world.object(b)).target().minus(drive(world.object(a)).target());
    }

    private static CentralForce drive(WorldObject object) {
        return (CentralForce) object.effects().getFirst();
    }

    @Test
    void itsNumbersAreThoseOfItsWorld() {
        Workload workload = Workload.of(150);
        double[] places = workload.positions();
        double[] targets = workload.targetPoints();

        assertThat(places).hasSize(450);
        for (WorldObject object : workload.world().build().objects()) {
            int at = 3 * (int) (object.id() - 1);
            assertThat(object.position())
                    .isEqualTo(new Vec3(places[at], places[at + 1], places[at + 2]));
            assertThat(drive(object).target())
                    .isEqualTo(new Vec3(targets[at], targets[at + 1], targets[at + 2]));
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2})
    void theSeedSaysAll(long seed) {
        Workload workload = new Workload(20, seed, 1, Targets.OWN);
        Workload other = new Workload(20, seed + 1, 1, Targets.OWN);

        assertThat(workload.positions()).isEqualTo(workload.positions());
        assertThat(workload.positions()).isNotEqualTo(other.positions());
        assertThat(workload.targetPoints()).isEqualTo(other.targetPoints());
    }

    @ParameterizedTest
    @EnumSource
    void theCubeCollapsesAndCollidesAndKeepsItsEnergy(Targets targets) {
        Workload workload = Workload.of(20).withTargets(targets);
        World world = workload.world().timeStep(0.01).build();
        int[] collisions = {0};
        world.addListener(event -> collisions[0] += event instanceof WorldEvent.Collided ? 1 : 0);
        double before = workload.energy(world);

        while (world.time() < 4) {
            world.advanceTimestep();
        }

        assertThat(collisions[0]).isPositive();
        assertThat(world.objects()).allMatch(o -> o.position().norm() < 15);
        assertThat(workload.energy(world)).isCloseTo(before, within(0.01 * before));
    }

    @ParameterizedTest
    @CsvSource({"9999, 120", "10000, 30", "100000, 10"})
    void largeOnesAreShorter(int bodies, double duration) {
        assertThat(Workload.of(bodies).duration()).isEqualTo(duration);
    }

    @Test
    void numbersThatMeanNothingAreRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Workload.of(0))
                .withMessage("a workload needs 1 or more bodies, but has 0");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Workload.of(1).withRestitution(1.5))
                .withMessage("the restitution must be 0 to 1, but is 1.5");
    }
}
