package org.auvsim.core.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.actuator.Battery;
import org.auvsim.core.actuator.PowerDraw;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

class BatteryGaugeTest {
    private static final BatteryGauge GAUGE =
            new BatteryGauge("gauge", "cells", ScalarErrors.NONE, Sampling.at(16));

    private static Propulsor drawing(double watts) {
        return new Propulsor(
                "screw",
                1,
                0.5,
                Vec3.ZERO,
                new Vec3(1, 0, 0),
                Optional.empty(),
                0,
                0,
                0,
                0,
                Optional.empty(),
                Optional.of(new PowerDraw("cells", watts, 0, true)),
                Optional.empty(),
                Optional.empty());
    }

    /** 0.5 cubed of 800 W is 100 W; an instant within a step is as exact as its end. */
    @Test
    void readsWhatIsLeftUntilNothingIs() {
        World world =
                World.builder()
                        .timeStep(0.1)
                        .add(
                                WorldObjectDefinition.named("body")
                                        .mass(1)
                                        .volume(new Sphere(0.1))
                                        .component(new Battery("cells", 200, 100))
                                        .component(drawing(800))
                                        .component(GAUGE)
                                        .build())
                        .build();
        List<WorldEvent.SensorRead> readings = new ArrayList<>();
        world.addListener(
                event -> {
                    if (event instanceof WorldEvent.SensorRead read) {
                        readings.add(read);
                    }
                });
        while (world.time() < 1.45) {
            world.advanceTimestep();
        }

        assertThat(readings).hasSize(24);
        for (WorldEvent.SensorRead read : readings) {
            BatteryReading reading = (BatteryReading) read.reading();
            assertThat(reading.charge())
                    .isCloseTo(Math.max(100 - 100 * read.measuredAt(), 0), within(1e-9));
        }
    }

    @Test
    void itsErrorsAreAsStated() {
        ScalarErrors errors = new ScalarErrors(3, 8, 0);
        BatteryGauge gauge = new BatteryGauge("gauge", "cells", errors, Sampling.at(20));
        World world =
                World.builder()
                        .add(Bench.ball(new Battery("cells", 200, 100), gauge).build())
                        .build();

        List<BatteryReading> readings = Bench.readings(world, BatteryReading.class, 250);

        int n = readings.size();
        assertThat(n).isEqualTo(5000);
        assertThat(Bench.variance(readings, BatteryReading::charge) / 9)
                .isCloseTo(1, within(5 * Math.sqrt(2.0 / n)));
        assertThat(Bench.mean(readings, BatteryReading::charge))
                .isCloseTo(108, within(5 * 3 / Math.sqrt(n)));
    }

    @Test
    void aGaugeWithoutItsBatteryIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(
                        () ->
                                WorldObjectDefinition.named("body")
                                        .mass(1)
                                        .volume(new Sphere(0.1))
                                        .component(GAUGE)
                                        .build())
                .withMessageContaining("component 'gauge' of 'body' needs a Battery 'cells'");
    }
}
