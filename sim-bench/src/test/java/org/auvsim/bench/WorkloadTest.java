package org.auvsim.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.behavior.GoToPoint;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.step.SnapshotStepper;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.junit.jupiter.api.Test;

class WorkloadTest {
    private static World world(int bodies) {
        return new Workload(bodies, 1).world(SnapshotStepper.standard());
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
            GoToPoint drive = object.component(GoToPoint.class).orElseThrow();

            assertThat(drive.target().norm()).isEqualTo(2, within(1e-9));
            assertThat(drive.force()).isEqualTo(10);
        }
    }

    @Test
    void clustersAreSixtyMetresApart() {
        World world = world(150);

        Vec3 between = target(world, 101).minus(target(world, 1)).minus(new Vec3(60, 0, 0));
        assertThat(between.norm()).isLessThan(1e-9);
    }

    private static Vec3 target(World world, int number) {
        return world.object("Sphere " + number).component(GoToPoint.class).orElseThrow().target();
    }

    @Test
    void theCubeCollapsesAndCollides() {
        World world = world(20);
        int[] collisions = {0};
        world.addListener(event -> collisions[0] += event instanceof WorldEvent.Collided ? 1 : 0);

        while (world.time() < 10) {
            world.advanceTimestep();
        }

        assertThat(collisions[0]).isPositive();
        assertThat(world.objects()).allMatch(o -> o.position().norm() < 15);
    }
}
