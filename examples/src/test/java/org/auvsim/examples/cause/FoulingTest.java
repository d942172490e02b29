package org.auvsim.examples.cause;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.effect.IsotropicDrag;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Test;

import java.util.List;

class FoulingTest {
    @Test
    void aDiagnosisLooksForIt() throws Exception {
        String scenario =
                """
                <scenario><world-object name="Buoy" mass="30"><sphere radius="0.2"/></world-object>
                </scenario>\
                """;
        BelievedModel model =
                new BelievedModel(
                        ScenarioLoader.load(FoulingTest.class.getClassLoader())
                                .parse(scenario.getBytes(UTF_8)),
                        "Buoy");
        MeasuredRun run =
                MeasuredRun.named("run").at(0).position(0, 0, 0).at(1).position(1, 0, 0).build();

        Cause fouling =
                Library.of(model, List.of(run)).stream()
                        .filter(cause -> cause.id().equals("fouling"))
                        .findFirst()
                        .orElseThrow();

        WorldObjectDefinition fouled = fouling.in(model.variant(), new double[] {2.5}).body();
        assertThat(fouled.mass()).hasValue(32.5);
        assertThat(fouled.effect()).containsExactly(new IsotropicDrag(0, 1, 0));
    }
}
