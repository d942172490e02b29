package org.auvsim.core.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.Bodies;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.volume.Sphere;
import org.junit.jupiter.api.Test;

import java.util.List;

class ContactForcesTest {
    private final Bodies bodies = new Bodies();
    private final Block block = new Block();

    private EquationsOfMotion equations() {
        bodies.add(1, WorldObjectDefinition.named("a").volume(new Sphere(1)).mass(2).build());
        return new EquationsOfMotion(
                bodies.state(),
                List.of(
                        new Gravity(10)
                                .layOut(List.of(List.of(new Gravity(10))), bodies.surroundings())));
    }

    @Test
    void aContactForceThatCarriesTheWeightKeepsABodyAtRestToTheBit() {
        EquationsOfMotion equations = equations();
        equations.load(block, 0, 1, 0);
        block.hasContactForces = true;
        block.hasContactTorques = true;
        block.contactFz[0] = 20;
        block.contactTx[0] = 3;
        equations.evaluate(block);
        new Rk4().advance(equations, block, 0.05);
        assertThat(block.state[BodyState.PZ][0]).isZero();
        assertThat(block.state[BodyState.Z][0]).isZero();
        assertThat(block.state[BodyState.LX][0]).isCloseTo(0.15, within(1e-16));
    }

    @Test
    void whatIsLoadedAnewHasNoContactForces() {
        EquationsOfMotion equations = equations();
        block.hasContactForces = true;
        block.hasContactTorques = true;
        block.contactFz[0] = 20;
        equations.load(block, 0, 1, 0);
        equations.evaluate(block);
        new Rk4().advance(equations, block, 0.05);
        assertThat(block.state[BodyState.PZ][0]).isCloseTo(-1, within(1e-14));
    }
}
