package org.auvsim.experiments.figures;

import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Entity;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** A run of a world, of whose body a line of a figure tells. */
final class Trial {
    private static final String BODY = "body";
    private static final double STEP = 0.01;

    private final WorldBuilder world = World.builder().timeStep(STEP);
    private double seconds = 10;

    private Trial() {}

    /** Of a body. */
    static Trial of(WorldObjectDefinition.Builder body) {
        Trial trial = new Trial();
        trial.world.add(body.build());
        return trial;
    }

    /** A ball of 10 kg and half a metre, with these effects. */
    static WorldObjectDefinition.Builder ball(Effect... effects) {
        WorldObjectDefinition.Builder ball =
                WorldObjectDefinition.named(BODY).volume(new Sphere(0.5)).mass(10);
        for (Effect effect : effects) {
            ball.effect(effect);
        }
        return ball;
    }

    /** A definition that the figures' bodies begin with. */
    static WorldObjectDefinition.Builder body() {
        return WorldObjectDefinition.named(BODY);
    }

    Trial in(Entity field) {
        world.add(field);
        return this;
    }

    /** With another body beside it. */
    Trial with(WorldObjectDefinition other) {
        world.add(other);
        return this;
    }

    Trial lasting(double duration) {
        seconds = duration;
        return this;
    }

    /** Something of the body over the time. */
    Series overTime(String name, ToDoubleFunction<WorldObject> y) {
        return run(name, (time, body) -> new Series.Point(time, y.applyAsDouble(body)));
    }

    /** The body's path from above. */
    Series path(String name) {
        return run(
                name,
                (time, body) -> {
                    Vec3 place = body.position();
                    return new Series.Point(place.x(), place.y());
                });
    }

    /** What a line takes from an instant. */
    private interface Sample {
        Series.Point of(double time, WorldObject body);
    }

    private Series run(String name, Sample sample) {
        World running = world.build();
        WorldObject body = running.object(BODY);
        List<Series.Point> points = new ArrayList<>();
        int steps = (int) Math.round(seconds / STEP);
        int stride = Math.max(1, steps / 250);
        for (int step = 0; step <= steps; step++) {
            if (step % stride == 0) {
                points.add(sample.of(running.time(), body));
            }
            running.advanceTimestep();
        }
        return new Series(name, points);
    }
}
