package org.auvsim.core.dynamics;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.effect.CentralForce;
import org.auvsim.core.effect.Damping;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Bodies;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.ArrayList;
import java.util.List;

class StiffnessTest {
    private static final double DT = 0.05;

    private static WorldObjectDefinition.Builder ball() {
        return WorldObjectDefinition.named("ball").volume(new Sphere(1)).mass(2);
    }

    private static int parts(WorldObjectDefinition.Builder body, Effect... effects) {
        Bodies bodies = new Bodies();
        bodies.add(1, body.build());
        List<BlockEffect> laidOut = new ArrayList<>();
        for (Effect effect : effects) {
            laidOut.add(effect.layOut(List.of(List.of(effect)), bodies.surroundings()));
        }
        EquationsOfMotion equations = new EquationsOfMotion(bodies.state(), laidOut);
        Block block = new Block();
        equations.load(block, 0, 1, 0);
        equations.evaluate(block);
        new Rk4().advance(equations, block, DT);
        return block.subSteps(0);
    }

    private static Damping linear(double c) {
        return new Damping(new Vec3(c, c, c), Vec3.ZERO, Vec3.ZERO, Vec3.ZERO);
    }

    @ParameterizedTest(name = "c dt / m = {0}")
    @CsvSource({"0.1, 1", "0.9, 1", "1.5, 2", "3, 4", "7, 8", "60, 64"})
    void linearDampingIsCutWhereRungeKuttaLosesAPercent(double z, int expected) {
        assertThat(parts(ball().velocity(1, 2, 3), linear(2 * z / DT))).isEqualTo(expected);
    }

    /** Else one motion is cut, another one beside it is not, and both part by more than both do. */
    @ParameterizedTest(name = "c dt / m = {0}")
    @CsvSource({"1, 1", "2, 2", "4, 4"})
    void roundingCutsNothing(double z, int expected) {
        Effect damping = linear(2 * z / DT);
        for (int k = 1; k <= 1000; k++) {
            assertThat(parts(ball().velocity(0.01 * k, 1.0 / k, 0), damping))
                    .as("at %s and %s m/s", 0.01 * k, 1.0 / k)
                    .isEqualTo(expected);
        }
    }

    @Test
    void stiffTurningIsFoundToo() {
        double c = 3.5 * 0.8 / DT;
        Damping damping = new Damping(Vec3.ZERO, Vec3.ZERO, new Vec3(c, c, c), Vec3.ZERO);
        assertThat(parts(ball().angularVelocity(1, 2, 3), damping)).isEqualTo(4);
    }

    @Test
    void aSmallMotionAcrossALargeOneIsFound() {
        Damping acrossOnly = new Damping(new Vec3(0, 240, 0), Vec3.ZERO, Vec3.ZERO, Vec3.ZERO);
        NamedForce thrust = NamedForce.direct("thrust", Frame.BODY, new Vec3(100, 0, 0));
        assertThat(parts(ball().velocity(10, 0.01, 0).force(thrust), acrossOnly)).isEqualTo(8);
    }

    @Test
    void aForceThatJumpsIsNoReasonToCut() {
        Effect push = new Switching(0.2);
        for (double x = -1; x < 0.3; x += 0.001) {
            WorldObjectDefinition.Builder ball = ball().velocity(8, 0, 0).position(x, 0, 0);
            assertThat(parts(ball, push)).as("from %s m", x).isEqualTo(1);
        }
    }

    /** 10 N toward a point. */
    private record Switching(double at) implements BodyEffect {
        @Override
        public void add(Block block, int i) {
            block.addForce(i, new Vec3(block.position(i).x() < at ? 10 : -10, 0, 0));
        }
    }

    @Test
    void plainBodiesAreWholeWhateverTheyDo() {
        assertThat(parts(ball().velocity(1, 2, 3))).isEqualTo(1);
        assertThat(parts(ball().velocity(1, 2, 3), new CentralForce(10, 0.1, Vec3.ZERO)))
                .isEqualTo(1);
        assertThat(parts(ball(), linear(1e6))).isEqualTo(1);
    }
}
