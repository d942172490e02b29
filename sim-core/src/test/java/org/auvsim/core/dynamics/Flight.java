package org.auvsim.core.dynamics;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Bodies;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** Bodies that move by the equations of motion alone: no world, no collisions. */
final class Flight {
    private final Bodies bodies = new Bodies();
    private final List<BlockEffect> effects = new ArrayList<>();
    private final List<Current> currents = new ArrayList<>();
    private final Block block = new Block();
    private EquationsOfMotion equations;
    private double time;

    private Flight(List<WorldObjectDefinition> definitions) {
        for (WorldObjectDefinition definition : definitions) {
            bodies.add(bodies.count() + 1, definition);
        }
        equations = new EquationsOfMotion(bodies.state(), effects);
    }

    static Flight of(WorldObjectDefinition.Builder body) {
        return of(List.of(body.build()));
    }

    /** At most as many as fit into a block. */
    static Flight of(List<WorldObjectDefinition> definitions) {
        return new Flight(definitions);
    }

    /** Lets an effect act on all bodies. */
    Flight with(Effect effect) {
        effects.add(
                effect.layOut(
                        Collections.nCopies(bodies.count(), List.of(effect)),
                        bodies.surroundings()));
        equations = new EquationsOfMotion(bodies.state(), effects);
        return this;
    }

    /** Adds a current. */
    Flight in(Current current) {
        currents.add(current);
        bodies.state().setFields(List.copyOf(currents));
        equations = new EquationsOfMotion(bodies.state(), effects);
        return this;
    }

    void advance(Integrator integrator, double dt, int steps) {
        for (int step = 0; step < steps; step++) {
            equations.load(block, 0, bodies.count(), time);
            equations.evaluate(block);
            integrator.advance(equations, block, dt);
            for (int c = 0; c < BodyState.COLUMNS; c++) {
                System.arraycopy(block.state[c], 0, bodies.state().column(c), 0, block.count);
            }
            time = block.time;
            bodies.state().setTime(time);
        }
    }

    double time() {
        return time;
    }

    WorldObject body() {
        return body(0);
    }

    WorldObject body(int slot) {
        return bodies.objects().get(slot);
    }

    /** Kinetic energy (J) of the first body. */
    double kineticEnergy() {
        Vec3 linear = body().linearMomentum();
        Vec3 angular = body().angularMomentum();
        return (linear.dot(body().velocity()) + angular.dot(body().angularVelocity())) / 2;
    }
}
