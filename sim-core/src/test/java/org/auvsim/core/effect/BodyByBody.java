package org.auvsim.core.effect;

import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.dynamics.DrawnBodies;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Entity;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;

import java.util.List;

/** An effect laid out for blocks moves drawn bodies as the same one written body by body does. */
final class BodyByBody {
    private static final int BODIES = 60;

    private BodyByBody() {}

    /** Every third body has none of it, every third one, every third two. */
    static void assertSameMotion(
            long seed, Effect forBlocks, BodyEffect forBodies, Entity... around) {
        World actual = world(seed, forBlocks, around);
        World expected = world(seed, forBodies, around);
        for (int step = 0; step < 5; step++) {
            actual.advanceTimestep();
            expected.advanceTimestep();
        }
        for (WorldObject object : actual.objects()) {
            WorldObject twin = expected.object(object.name());
            assertNear(object.linearMomentum(), twin.linearMomentum(), 1e-10);
            assertNear(object.angularMomentum(), twin.angularMomentum(), 1e-10);
        }
    }

    private static World world(long seed, Effect effect, Entity... around) {
        WorldBuilder world = World.builder().timeStep(0.01).allowOverlaps();
        List<WorldObjectDefinition> drawn = DrawnBodies.of(seed, BODIES);
        for (Entity entity : around) {
            world.add(entity);
        }
        for (int i = 0; i < drawn.size(); i++) {
            world.add(of(drawn.get(i), List.of(effect, effect).subList(0, i % 3)));
        }
        return world.build();
    }

    /** In a layer of its own kind, which it ignores: nothing collides. */
    private static WorldObjectDefinition of(WorldObjectDefinition body, List<Effect> effects) {
        WorldObjectDefinition.Builder copy =
                WorldObjectDefinition.named(body.name())
                        .volume(body.volume())
                        .mass(body.mass().orElseThrow())
                        .inertia(body.inertia().orElseThrow())
                        .position(body.position())
                        .orientation(body.orientation())
                        .velocity(body.velocity().x(), body.velocity().y(), body.velocity().z())
                        .angularVelocity(
                                body.angularVelocity().x(),
                                body.angularVelocity().y(),
                                body.angularVelocity().z())
                        .ignores(0);
        effects.forEach(copy::effect);
        return copy.build();
    }
}
