package org.auvsim.core.sensor;

import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** A body with a sensor, and what that reads. */
final class Bench {
    private Bench() {}

    /** A ball of 0.5 m and 1 kg with these components. */
    static WorldObjectDefinition.Builder ball(Component... components) {
        WorldObjectDefinition.Builder ball =
                WorldObjectDefinition.named("Ball").id(1).volume(new Sphere(0.5)).mass(1);
        for (Component component : components) {
            ball.component(component);
        }
        return ball;
    }

    /** A world with a ball that has this sensor, at rest at the origin. */
    static World world(Sensor sensor) {
        return World.builder().add(ball(sensor).build()).build();
    }

    /** All readings of a kind while a world runs for some time (s). */
    static <R extends SensorReading> List<R> readings(World world, Class<R> kind, double time) {
        List<R> heard = new ArrayList<>();
        world.addListener(
                event -> {
                    if (event instanceof WorldEvent.SensorRead read) {
                        heard.add(kind.cast(read.reading()));
                    }
                });
        double end = world.time() + time - 1e-9;
        while (world.time() < end) {
            world.advanceTimestep();
        }
        return heard;
    }

    /** The only reading of a 20 Hz sensor in a step. */
    static <R extends SensorReading> R reading(World world, Class<R> kind) {
        List<R> readings = readings(world, kind, 0.05);
        if (readings.size() != 1) {
            throw new AssertionError("expected one reading, but there are " + readings);
        }
        return readings.getFirst();
    }

    static Quat yaw(double angle) {
        return Quat.ofAxisAngle(new Vec3(0, 0, 1), angle);
    }

    static Quat pitch(double angle) {
        return Quat.ofAxisAngle(new Vec3(0, 1, 0), angle);
    }

    static <T> double mean(List<T> of, ToDoubleFunction<T> value) {
        return of.stream().mapToDouble(value).average().orElseThrow();
    }

    static <T> double variance(List<T> of, ToDoubleFunction<T> value) {
        double mean = mean(of, value);
        return of.stream()
                .mapToDouble(value)
                .map(x -> (x - mean) * (x - mean))
                .average()
                .orElseThrow();
    }
}
