package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.shooting.WindowDerivatives.Moves;
import org.junit.jupiter.api.Test;

import java.util.List;

class HypothesisTest {
    /** The mass, which cannot be above 5 kg. */
    private record Mass() implements Cause {
        @Override
        public String id() {
            return "mass";
        }

        @Override
        public List<Parameter> parameters() {
            return List.of(new Parameter("mass", "kg", 1, 1, 5));
        }

        @Override
        public Variant in(Variant model, double[] theta) {
            assertThat(theta[0]).isBetween(1.0, 5.0);
            return model.with(body -> body.mass(theta[0]));
        }
    }

    private static double movedFrom(double mass) throws Exception {
        String scenario =
                """
                <scenario><world-object name="Ball" mass="2"><sphere radius="0.2"/></world-object>
                </scenario>\
                """;
        Variant model =
                new BelievedModel(
                                ScenarioLoader.load(HypothesisTest.class.getClassLoader())
                                        .parse(scenario.getBytes(UTF_8)),
                                "Ball")
                        .variant();
        Moves moves =
                new Hypothesis(List.of(new Mass()), List.of(new double[] {mass})).moves(model);
        double moved = moves.variants().getFirst().body().mass().orElseThrow();
        assertThat(moves.steps().getFirst()).isCloseTo(moved - mass, within(1e-12));
        return moved;
    }

    @Test
    void parametersAreMovedWithinTheirBounds() throws Exception {
        assertThat(movedFrom(3)).isCloseTo(3.001, within(1e-12));
        assertThat(movedFrom(1)).isCloseTo(1.001, within(1e-12));
        assertThat(movedFrom(5)).isCloseTo(4.999, within(1e-12));
    }
}
