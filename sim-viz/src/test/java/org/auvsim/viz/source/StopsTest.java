package org.auvsim.viz.source;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.ApplyDirectForceCommand;
import org.auvsim.auvsml.message.control.ApplyForceCommand;
import org.auvsim.auvsml.message.control.RemoveForceCommand;
import org.auvsim.auvsml.message.control.ResetCommand;
import org.auvsim.auvsml.message.control.SetControlSurfaceCommand;
import org.auvsim.auvsml.message.control.SetPropulsorCommand;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;

import java.util.stream.DoubleStream;
import java.util.stream.Stream;

class StopsTest {
    @Test
    void areOrdersOfNothing() {
        assertThat(DoubleStream.of(0, -0.0).boxed().flatMap(StopsTest::orders))
                .hasSize(8)
                .allMatch(Stops::is);
        assertThat(new RemoveForceCommand(1, "Viewer")).matches(Stops::is);
        assertThat(orders(0.1)).noneMatch(Stops::is);
        assertThat(new ResetCommand()).matches(order -> !Stops.is(order));
    }

    /** Orders of every kind that push or turn so much. */
    private static Stream<Message> orders(double much) {
        Vec3 force = new Vec3(0, much, 0);
        return Stream.of(
                new SetPropulsorCommand(1, "Propeller", much),
                new SetControlSurfaceCommand(1, "Rudder", much),
                new ApplyDirectForceCommand(1, "Viewer", Frame.BODY, force),
                new ApplyForceCommand(1, "Viewer", Frame.BODY, force, new Vec3(1, 0, 0)));
    }
}
