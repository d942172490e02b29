package org.auvsim.core.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.effect.IsotropicDrag;
import org.auvsim.core.effect.Tether;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;

import java.util.List;

/** An object gets another mass, other effects and components while it moves. */
class RevisedObjectTest {
    private static final double STEP = 0.05;
    private static final Vec3 VELOCITY = new Vec3(1, -2, 0.5);
    private static final Vec3 SPIN = new Vec3(0.1, 0.2, -0.3);
    private static final NamedForce PUSH =
            NamedForce.direct("push", Frame.WORLD, new Vec3(3, 0, 0));

    private static WorldObjectDefinition.Builder believed() {
        return Balls.ball("ball")
                .component(new Propulsor("screw", 10, 0, Vec3.ZERO, new Vec3(0, 0, 1)));
    }

    /** It moves, is pushed, and its propulsor runs at half its power. */
    private static World underWay(WorldObjectDefinition... others) {
        WorldBuilder builder = World.builder().timeStep(STEP).add(believed().build());
        for (WorldObjectDefinition other : others) {
            builder.add(other);
        }
        World world = builder.build();
        WorldObject ball = world.object("ball");
        ball.setVelocity(VELOCITY);
        ball.setAngularVelocity(SPIN);
        ball.applyForce(PUSH);
        ball.command(Propulsor.class, "screw", 0.5);
        world.advanceTimestep();
        return world;
    }

    @Test
    void itMovesOnAsItDidWithMoreMomentumIfItIsHeavier() {
        World world = underWay();
        WorldObject former = world.object("ball");
        Vec3 position = former.position();
        Quat orientation = former.orientation();
        Vec3 velocity = former.velocity();

        WorldObject revised = world.revise(believed().mass(4).position(9, 9, 9).build());

        assertThat(world.object(former.id())).isSameAs(revised);
        assertThat(revised.position()).isEqualTo(position);
        assertThat(revised.orientation()).isEqualTo(orientation);
        assertThat(revised.velocity().distance(velocity)).isCloseTo(0, within(1e-12));
        assertThat(revised.angularVelocity().distance(SPIN)).isCloseTo(0, within(1e-12));
        assertThat(revised.linearMomentum().distance(velocity.times(4)))
                .isCloseTo(0, within(1e-12));
    }

    @Test
    void whatItIsToldStaysAndActsOnTheNewMass() {
        World world = underWay();
        Vec3 before = world.object("ball").velocity();

        WorldObject revised = world.revise(believed().mass(4).build());
        world.advanceTimestep();

        assertThat(revised.forces()).containsExactly(PUSH);
        Vec3 acceleration = revised.velocity().minus(before).times(1 / STEP);
        Vec3 thrust = new Vec3(0, 0, 0.5 * 10); // it has hardly turned
        Vec3 expected = PUSH.vector().plus(thrust).times(1.0 / 4);
        assertThat(acceleration.distance(expected)).isLessThan(0.05);
    }

    @Test
    void itsNewEffectsActInsteadOfItsFormerOnes() {
        World world = underWay();
        world.addEffect(world.object("ball").id(), new IsotropicDrag(1, 0, 0));

        WorldObject revised = world.revise(believed().effect(new IsotropicDrag(0, 2, 0)).build());

        assertThat(revised.effects()).containsExactly(new IsotropicDrag(0, 2, 0));
        double speed = revised.velocity().norm();
        world.revise(Balls.ball("ball").effect(new IsotropicDrag(0, 2, 0)).build());
        world.object("ball").setForces(List.of());
        world.advanceTimestep();
        // m v' = -k v^2 has the solution v = v0 / (1 + k v0 t / m)
        assertThat(world.object("ball").velocity().norm())
                .isCloseTo(speed / (1 + 2 * speed * STEP), within(1e-4));
    }

    @Test
    void whoHangsOnItStillDoes() {
        WorldObjectDefinition load =
                Balls.ball("load")
                        .id(7)
                        .position(0, 5, 0)
                        .effect(new Tether(1, Vec3.ZERO, Vec3.ZERO, 1, 100, 0))
                        .build();
        World world = underWay(load);
        world.revise(believed().mass(4).build());
        Vec3 before = world.object("load").velocity();

        world.advanceTimestep();

        assertThat(world.object("load").velocity().y()).isLessThan(before.y() - 1);
    }

    @Test
    void whoIsNotThereIsNotRevised() {
        World world = underWay();

        assertThatThrownBy(() -> world.revise(Balls.ball("box").build()))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("box");
    }
}
