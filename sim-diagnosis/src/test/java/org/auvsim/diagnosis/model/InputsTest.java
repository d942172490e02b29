package org.auvsim.diagnosis.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.junit.jupiter.api.Test;

import java.util.List;

/** A thruster that takes 2 s to follow commands: full ahead, and from 3 s on half astern. */
class InputsTest {
    private static final double LAG = 2;
    private static final int SAMPLES = 101;
    private static final String MODEL =
            """
            <scenario><time-step delta="0.1"/>
              <world-object name="box" mass="2"><box><size x="1" y="1" z="1"/></box>
                <propulsor name="ahead" maximum-thrust="10" lag="2"/>
              </world-object></scenario>
            """;

    private static MeasuredRun run() {
        MeasuredRunBuilder run = MeasuredRun.named("run").commands(List.of("ahead"));
        for (int k = 0; k < SAMPLES; k++) {
            run.at(0.1 * k).command(0, k < 30 ? 1 : -0.5);
        }
        return run.build();
    }

    /** That which the thruster works at where a run has come to a sample. */
    private static double level(MeasuredRun run, int sample) throws Exception {
        WorldObjectDefinition box =
                ScenarioLoader.load(InputsTest.class.getClassLoader())
                        .parse(MODEL.getBytes(UTF_8))
                        .worldObject()
                        .getFirst();
        List<Component> now = new Inputs(run, box).before(sample, box.component());
        return ((Propulsor) now.getFirst()).levelAt(run.time(sample));
    }

    private static double atThree() {
        return 1 - Math.exp(-3 / LAG);
    }

    @Test
    void aWholeRunBeginsAsTheScenarioHasIt() throws Exception {
        assertThat(level(run(), 0)).isZero();
        assertThat(level(run(), 20)).isCloseTo(1 - Math.exp(-2 / LAG), within(1e-12));
    }

    @Test
    void aPartBeginsWithWhatWasCommandedBeforeIt() throws Exception {
        assertThat(level(run().part("part", 20, 60), 0))
                .isCloseTo(1 - Math.exp(-2 / LAG), within(1e-12));
        assertThat(level(run().part("part", 30, 60), 0)).isCloseTo(atThree(), within(1e-12));
        assertThat(level(run().part("part", 20, 60), 30))
                .isCloseTo(-0.5 + (atThree() + 0.5) * Math.exp(-2 / LAG), within(1e-12));
    }

    @Test
    void soDoesAPartOfAPart() throws Exception {
        MeasuredRun part = run().part("later", 20, 90).part("latest", 25, 50);

        assertThat(part.time(0)).isCloseTo(4.5, within(1e-12));
        assertThat(level(part, 0))
                .isCloseTo(-0.5 + (atThree() + 0.5) * Math.exp(-1.5 / LAG), within(1e-12));
    }
}
