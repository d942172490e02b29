package org.auvsim.core.sensor;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.LayeredTemperature;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.field.UniformMagneticField;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.HalfSpace;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.auvsim.core.world.WorldListener;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/** What every sensor keeps, a user's own too: its readings depend on nothing but world and seed. */
public abstract class SensorContract {
    private static final int STEPS = 40;

    /** A sensor with errors that measures so. */
    protected abstract Sensor sensor(Sampling sampling);

    private static Sampling sampling(long seed) {
        return new Sampling(30, 0.07, 0.1, seed);
    }

    /** Two vehicles that turn and drift apart at the surface over a bottom, one with the sensor. */
    private World world(long seed) {
        return World.builder()
                .datum(new Datum(36.6, -121.9, -33))
                .add(new UniformCurrent(10, "Tide", new Vec3(0.1, 0.2, 0)))
                .add(new UniformMagneticField(11, "Earth", new Vec3(5e-6, 2e-5, -4e-5)))
                .add(new LayeredTemperature(12, "Summer", 16, 0.1, 0, 0, 1, 0))
                .add(
                        WorldObjectDefinition.named("Bottom")
                                .id(3)
                                .fixed()
                                .volume(new HalfSpace())
                                .position(0, 0, -9)
                                .build())
                .add(vehicle("Other", 4).id(2).velocity(0.3, 0, 0).build())
                .add(
                        vehicle("Vehicle", 0)
                                .id(1)
                                .velocity(0.1, 0.2, -0.05)
                                .angularVelocity(0.05, -0.1, 0.2)
                                .component(sensor(sampling(seed)))
                                .build())
                .build();
    }

    private static WorldObjectDefinition.Builder vehicle(String name, double x) {
        return WorldObjectDefinition.named(name)
                .mass(5)
                .volume(new Sphere(0.5))
                .position(x, 0, 0.5);
    }

    private static List<WorldEvent.SensorRead> readings(World world, int steps) {
        List<WorldEvent.SensorRead> heard = new ArrayList<>();
        WorldListener listener =
                event -> {
                    if (event instanceof WorldEvent.SensorRead read) {
                        heard.add(read);
                    }
                };
        world.addListener(listener);
        for (int i = 0; i < steps; i++) {
            world.advanceTimestep();
        }
        world.removeListener(listener);
        return heard;
    }

    @Test
    void anEqualWorldReadsTheSameAndAnotherSeedDoesNot() {
        List<WorldEvent.SensorRead> heard = readings(world(3), STEPS);

        assertThat(heard).hasSizeGreaterThan(40);
        assertThat(readings(world(3), STEPS)).isEqualTo(heard);
        assertThat(readings(world(4), STEPS)).isNotEqualTo(heard);
    }

    @Test
    void aCopyInMidRunReadsOnAsTheOriginal() {
        World world = world(3);
        readings(world, STEPS / 2);
        World copy = world.copy();

        List<WorldEvent.SensorRead> heard = readings(world, STEPS / 2);
        assertThat(readings(copy, STEPS / 2)).isNotEmpty().isEqualTo(heard);
    }

    @Test
    void itReadsTheSameWhetherSomebodyListenedBeforeOrNot() {
        World heardBefore = world(3);
        readings(heardBefore, STEPS / 2);
        World unheard = world(3);
        for (int i = 0; i < STEPS / 2; i++) {
            unheard.advanceTimestep();
        }

        assertThat(readings(unheard, STEPS / 2)).isEqualTo(readings(heardBefore, STEPS / 2));
    }
}
