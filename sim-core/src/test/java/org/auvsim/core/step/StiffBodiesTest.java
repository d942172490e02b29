package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.effect.Damping;
import org.auvsim.core.entity.AddedMass;
import org.auvsim.core.entity.AddedMassTerm;
import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.MotionAxis;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;

import java.util.List;

/**
 * The REMUS with its printed damping (Prestero 2001, as used with Yvv -1310, Mqq -188, Nrr -94),
 * with which a Runge-Kutta step of 0.05 s diverges.
 */
class StiffBodiesTest {
    private static WorldObjectDefinition.Builder remus() {
        return WorldObjectDefinition.named("REMUS")
                .volume(new Box(new Vec3(1.33, 0.19, 0.19)))
                .mass(30.48)
                .inertia(new Inertia(0.177, 3.45, 3.45, 0, 0, 0))
                .centreOfMass(new Vec3(0, 0, -0.0196))
                .addedMass(
                        new AddedMass(
                                new Vec3(0.93, 35.5, 35.5),
                                new Vec3(0.0704, 4.88, 4.88),
                                List.of(
                                        new AddedMassTerm(MotionAxis.SWAY, MotionAxis.YAW, -1.93),
                                        new AddedMassTerm(
                                                MotionAxis.HEAVE, MotionAxis.PITCH, 1.93))))
                .effect(
                        new Damping(
                                Vec3.ZERO,
                                new Vec3(1.62, 1310, 131),
                                Vec3.ZERO,
                                new Vec3(0.13, 188, 94)));
    }

    private static World world(WorldObjectDefinition.Builder body, double dt) {
        return World.builder()
                .timeStep(dt)
                .stepper(
                        new SnapshotStepper(
                                new NoRestricter(),
                                new AllPairsPartitioner(),
                                new EndOfStepFinder()))
                .add(body.build())
                .build();
    }

    private static WorldObject after(World world, int steps) {
        for (int i = 0; i < steps; i++) {
            world.advanceTimestep();
        }
        return world.object("REMUS");
    }

    @Test
    void theRemusSlowsDownAsWithAThousandTimesSmallerSteps() {
        WorldObjectDefinition.Builder sway = remus().velocity(1.5, 3, 0).angularVelocity(0, 3, 0.5);
        World coarse = world(sway, 0.05);
        WorldObject body = after(coarse, 40);
        WorldObject fine = after(world(sway, 0.00005), 40_000);
        assertNear(body.velocity(), fine.velocity(), 0.02);
        assertNear(body.angularVelocity(), fine.angularVelocity(), 0.02);
        assertNear(body.position(), fine.position(), 0.03);
        assertThat(body.velocity().norm()).isLessThan(1.5);
        assertThat(coarse.statistics().subSteps()).isBetween(2L, 400L);
    }

    @Test
    void ordinaryDampingIsNotCut() {
        World world =
                world(
                        WorldObjectDefinition.named("REMUS")
                                .volume(new Box(new Vec3(1, 1, 1)))
                                .mass(30)
                                .velocity(2, 1, 0)
                                .effect(
                                        new Damping(
                                                new Vec3(5, 5, 5),
                                                new Vec3(10, 10, 10),
                                                new Vec3(1, 1, 1),
                                                Vec3.ZERO)),
                        0.05);
        after(world, 100);
        assertThat(world.statistics().subSteps()).isZero();
    }

    @Test
    void whatIsTooStiffIsSaidAndNothingHasMoved() {
        Vec3 huge = new Vec3(1e9, 1e9, 1e9);
        World world =
                world(
                        remus().velocity(1, 0, 0)
                                .effect(new Damping(huge, Vec3.ZERO, Vec3.ZERO, Vec3.ZERO)),
                        0.05);
        long before = world.stateHash();
        assertThatThrownBy(world::advanceTimestep)
                .isInstanceOf(StepException.class)
                .hasMessageContaining("'REMUS'")
                .hasMessageContaining("too stiff");
        assertThat(world.stateHash()).isEqualTo(before);
    }
}
