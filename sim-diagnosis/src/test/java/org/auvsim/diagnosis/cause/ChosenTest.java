package org.auvsim.diagnosis.cause;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.model.Variant;
import org.junit.jupiter.api.Test;

import java.util.Collections;
import java.util.List;

class ChosenTest {
    /** What it gains by being one of two out of 200. */
    private static final double LESS = 2 * Math.log(100);

    private static class Plain implements Cause {
        @Override
        public String id() {
            return "plain";
        }

        @Override
        public List<Parameter> parameters() {
            return List.of(Parameter.positive("share", "1", 0.1));
        }

        @Override
        public Variant in(Variant model, double[] theta) {
            return model;
        }
    }

    private static final class Rare extends Plain {
        @Override
        public double price() {
            return 30;
        }
    }

    private static final class Untold extends Plain {
        @Override
        public double price(int measured, double independent) {
            return 50 + Math.log(measured) + independent;
        }
    }

    private static Cause chosen(Cause cause) {
        List<Cause> library = Collections.nCopies(200, cause);
        return Chosen.of(library.subList(0, 2), library).getFirst();
    }

    @Test
    void itIsAsMuchCheaperAsItWouldHaveCost() {
        assertThat(chosen(new Plain()).price()).isCloseTo(12 - LESS, within(1e-12));
        assertThat(chosen(new Rare()).price()).isCloseTo(30 - LESS, within(1e-12));
        assertThat(chosen(new Rare()).price(1000, 40))
                .isCloseTo(30 - LESS + Math.log(40), within(1e-12));
        assertThat(chosen(new Untold()).price(1000, 40))
                .isCloseTo(50 + Math.log(40) + 40 - LESS, within(1e-12));
    }

    @Test
    void atLeastItsNumbersCost() {
        Cause cause = new Plain();
        List<Cause> library = Collections.nCopies(10_000, cause);

        Cause chosen = Chosen.of(List.of(cause), library).getFirst();

        assertThat(chosen.price()).isEqualTo(0);
        assertThat(chosen.price(1000, 40)).isCloseTo(Math.log(40), within(1e-12));
    }
}
