package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.shooting.WindowBlock;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

import java.util.Collections;
import java.util.List;

/** Products of columns. */
public class GramTest {
    private static final Cart CART = new Cart(0.8, 2, 0.1);

    @Test
    void thoseOfSomeAreToTheBitThoseAmongAll() throws Exception {
        Hypothesis both =
                new Hypothesis(
                        List.of(CART.cause("linear_drag"), CART.cause("thruster_gain")),
                        List.of(new double[] {1}, new double[] {-0.1}));
        Fit fit = CART.fit(both);
        List<List<WindowBlock>> blocks = fit.blocks(fit.derivatives(), 2);

        Gram all = Gram.of(blocks, 2);
        Gram one = Gram.of(blocks, new int[] {1}, 2);
        Gram exchanged = Gram.of(blocks, new int[] {1, 0}, 2);

        assertThat(one.columns()).isEqualTo(1);
        assertThat(one.product(0, 0)).isEqualTo(all.product(1, 1));
        assertThat(one.cost()).isEqualTo(all.cost());
        assertThat(one.solve(new int[] {0}, free(1))).isEqualTo(all.solve(new int[] {1}, free(1)));
        assertThat(exchanged.solve(new int[] {0, 1}, free(2)))
                .isEqualTo(all.solve(new int[] {1, 0}, free(2)));
    }

    /** (a - 1)^2 + (b + 2)^2 + (a + b)^2, the lowest where a = 4/3 and b = -5/3. */
    private static final Gram BOWL = new Gram(new double[][] {{2, 1, -1}, {1, 2, 2}, {-1, 2, 5}});

    /** What b does is beyond all numbers: a goes where it would alone. */
    @Test
    void whatIsOutOfAllBoundsStaysWhereItIs() {
        double over = Double.POSITIVE_INFINITY;
        Gram gram = new Gram(new double[][] {{2, 0, -4}, {0, over, over}, {-4, over, 9}});
        int[] both = {0, 1};

        double[] change = gram.solve(both, free(2));

        assertThat(change[0]).isCloseTo(2, within(1e-8));
        assertThat(change[1]).isZero();
        assertThat(gram.drop(both, change)).isCloseTo(8, within(1e-8));
    }

    /** The cost is lowest 500 scales away, though noise hides all that is nearer than 1000. */
    @Test
    void whatTheDataHardlyTellsIsHardlyMoved() {
        Gram hardlyTold = new Gram(new double[][] {{1e-6, -5e-4}, {-5e-4, 1}});
        Gram told = new Gram(new double[][] {{1e4, -5e4}, {-5e4, 1e6}});
        List<Parameter> one = List.of(Parameter.signed("a", "1", 1));

        assertThat(hardlyTold.solve(new int[] {0}, free(1))[0]).isCloseTo(500, within(0.1));
        assertThat(hardlyTold.cautious(one).solve(new int[] {0}, free(1))[0]).isBetween(0.0, 1.0);
        assertThat(told.cautious(one).solve(new int[] {0}, free(1))[0]).isCloseTo(5, within(1e-5));
    }

    /** A damped step of b would be of 500 by the size of its own column, as good as 0 here. */
    @Test
    void aColumnThatIsNothingJustHereIsDampedAsOneOfSomeSize() {
        Gram gram = new Gram(new double[][] {{1, 0, -1}, {0, 1e-6, -1e-3}, {-1, -1e-3, 9}});
        int[] both = {0, 1};

        double[] bySize = gram.solve(both, free(2), 1, new double[2]);
        double[] byLeast = gram.solve(both, free(2), 1, new double[] {0, 0.1});

        assertThat(bySize[0]).isCloseTo(0.5, within(1e-8));
        assertThat(bySize[1]).isCloseTo(500, within(1e-5));
        assertThat(byLeast[0]).isCloseTo(0.5, within(1e-8));
        assertThat(byLeast[1]).isCloseTo(1e-3 / (1e-6 + 0.01), within(1e-8));
    }

    @Test
    void whatMayBeAnyNumberIsWhereTheCostIsLowest() {
        double[] change = BOWL.solve(new int[] {0, 1}, free(2));

        assertThat(change[0]).isCloseTo(4.0 / 3, within(1e-8));
        assertThat(change[1]).isCloseTo(-5.0 / 3, within(1e-8));
    }

    /** Where b = 0, the cost is lowest at a = 1/2. */
    @Test
    void theOthersMakeUpForWhatStopsAtItsBound() {
        Bounds bounds = bounds(Parameter.signed("a", "1", 1), Parameter.positive("b", "1", 1));

        double[] change = BOWL.solve(new int[] {0, 1}, bounds);

        assertThat(change[0]).isCloseTo(0.5, within(1e-8));
        assertThat(change[1]).isZero();
    }

    @Test
    void boundsAreThoseOfTheNumberNotOfItsChange() {
        Bounds bounds =
                Bounds.of(
                        List.of(Parameter.signed("a", "1", 1), new Parameter("b", "1", 1, 0, 9)),
                        new double[] {3, 1});

        assertThat(BOWL.solve(new int[] {0, 1}, bounds)[1]).isEqualTo(-1);
    }

    /** Of numbers that may be any. */
    public static Bounds free(int size) {
        return bounds(
                Collections.nCopies(size, Parameter.signed("any", "1", 1))
                        .toArray(Parameter[]::new));
    }

    private static Bounds bounds(Parameter... parameters) {
        return Bounds.of(List.of(parameters), new double[parameters.length]);
    }
}
