package org.auvsim.core.dynamics;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;

import java.util.List;
import java.util.stream.IntStream;

/** Random bodies with inertia, forces and a propulsor, from a seed. */
public final class DrawnBodies {
    private DrawnBodies() {}

    /** This many, at most a block full. */
    public static List<WorldObjectDefinition> of(long seed, int count) {
        Draws draws = new Draws(seed);
        return IntStream.range(0, count).mapToObj(i -> body(draws, "body " + i)).toList();
    }

    private static WorldObjectDefinition body(Draws draws, String name) {
        Vec3 v = draws.vector(2);
        Vec3 w = draws.vector(1);
        return WorldObjectDefinition.named(name)
                .volume(new Box(draws.vector(0.5, 2)))
                .mass(draws.number(1, 50))
                .inertia(
                        new Inertia(
                                draws.number(2, 4),
                                draws.number(2, 4),
                                draws.number(2, 4),
                                draws.number(-0.5, 0.5),
                                draws.number(-0.5, 0.5),
                                draws.number(-0.5, 0.5)))
                .position(draws.vector(10))
                .orientation(draws.orientation())
                .velocity(v.x(), v.y(), v.z())
                .angularVelocity(w.x(), w.y(), w.z())
                .force(new NamedForce("fixed", Frame.WORLD, draws.vector(5), draws.vector(1)))
                .force(new NamedForce("carried", Frame.BODY, draws.vector(5), draws.vector(1)))
                .component(
                        new Propulsor(
                                "screw",
                                draws.number(0, 10),
                                draws.number(-1, 1),
                                draws.vector(1),
                                draws.direction()))
                .build();
    }
}
