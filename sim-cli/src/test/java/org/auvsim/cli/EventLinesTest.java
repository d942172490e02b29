package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.message.radio.RadioMessage;
import org.auvsim.auvsml.message.sensing.SensorReadingMessage;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.sensor.DvlReading;
import org.auvsim.core.sensor.DvlReference;
import org.auvsim.core.sensor.RangeReading;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.OptionalDouble;

class EventLinesTest {
    private final EventLines lines =
            new EventLines(
                    List.of(new ServedObject(47, "Juggernaut"), new ServedObject(3, "Buoy")));

    @Test
    void aReadingHasItsValuesByTheirNames() {
        DvlReading log =
                new DvlReading(new Vec3(1, 0.5, 0), DvlReference.WATER, OptionalDouble.empty());
        RangeReading echoes = new RangeReading(List.of(new RangeReading.Echo(2, 7.5)));

        assertThat(lines.of(new SensorReadingMessage(2.1, 47, "Log", 2, log)))
                .contains(
                        "     2.000  Juggernaut       reads Log: velocity.x 1.0, velocity.y 0.5,"
                                + " velocity.z 0.0, reference WATER");
        assertThat(lines.of(new SensorReadingMessage(2.1, 9, "Sonar", 2, echoes)))
                .contains(
                        "     2.000  #9               reads Sonar: echo.0.beam 2, echo.0.distance"
                                + " 7.5");
    }

    @Test
    void aMessageIsHeardFromItsSender() {
        assertThat(lines.of(new RadioMessage(2.5, 3, 47, "Modem", "1", 2, "surface!")))
                .contains("     2.500  Buoy             hears Juggernaut: surface!");
    }
}
