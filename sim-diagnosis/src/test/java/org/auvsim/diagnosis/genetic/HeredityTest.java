package org.auvsim.diagnosis.genetic;

import static org.assertj.core.api.Assertions.assertThat;

import org.apache.commons.math3.genetics.ChromosomePair;
import org.apache.commons.math3.random.Well19937c;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.genetic.ModelGenome.Gene;
import org.auvsim.diagnosis.model.Variant;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Set;

/** Causes that share a name, as the angle and the tilt of one thruster, are two genes. */
class HeredityTest {
    private static final Cause ANGLE = new Turned("angle");
    private static final Cause TILT = new Turned("tilt");

    private record Turned(String aspect) implements Cause {
        @Override
        public String id() {
            return "turned";
        }

        @Override
        public String label() {
            return "turned (%s)".formatted(aspect);
        }

        @Override
        public List<Parameter> parameters() {
            return List.of(Parameter.signed(aspect, "rad", 0.1));
        }

        @Override
        public Variant in(Variant model, double[] theta) {
            return model;
        }
    }

    private static ModelGenome of(Cause... causes) {
        return new ModelGenome(
                List.of(causes).stream().map(c -> new Gene(c, new double[] {1})).toList());
    }

    @Test
    void noGeneIsLostInACrossover() {
        for (int seed = 0; seed < 20; seed++) {
            Heredity heredity = new Heredity(List.of(ANGLE, TILT), List.of(), new Well19937c(seed));

            ChromosomePair children = heredity.crossover(of(ANGLE, TILT), of(TILT, ANGLE));

            int genes =
                    ((ModelGenome) children.getFirst()).genes().size()
                            + ((ModelGenome) children.getSecond()).genes().size();
            assertThat(genes).as("seed %d", seed).isEqualTo(4);
        }
    }

    @Test
    void setsOfOneNameAreTwo() {
        assertThat(of(ANGLE).causes()).isEqualTo(Set.of(ANGLE)).isNotEqualTo(of(TILT).causes());
        assertThat(of(ANGLE, TILT).causes()).isEqualTo(of(TILT, ANGLE).causes());
    }
}
