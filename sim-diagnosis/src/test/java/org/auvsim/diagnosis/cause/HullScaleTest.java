package org.auvsim.diagnosis.cause;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.subject.MeasuredTorpedo;
import org.junit.jupiter.api.Test;

import java.util.List;

/**
 * Steps of a search are held to some thirty scales of a number: a torpedo's moment by its sway is
 * of the size of what it carries of the water (Munk 1924), 32 kg here.
 */
class HullScaleTest {
    @Test
    void momentsOfAHullAreWithinReach() throws Exception {
        BelievedModel model = MeasuredTorpedo.model(MeasuredTorpedo.RUDDER);
        List<MeasuredRun> runs = List.of(MeasuredTorpedo.run(model, 1, 0, Vec3.ZERO));
        Parameter moment =
                Library.of(model, runs).stream()
                        .filter(cause -> cause.id().equals("hull_lift"))
                        .flatMap(cause -> cause.parameters().stream())
                        .filter(parameter -> parameter.name().equals("Nuv"))
                        .findFirst()
                        .orElseThrow();

        assertThat(30 * moment.scale()).isBetween(10.0, 200.0);
    }
}
