package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.result.Identifiability.Smallest;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;
import java.util.Random;

/** Of a cart that lacks nothing it is told how much it could lack without being found out. */
class SmallestTest {
    private static final double MASS = 10;
    private static final double THRUST = 20;
    private static final double SPACING = 0.1;
    private static final int SAMPLES = 400;
    private static final double NOISE = 0.002;

    /**
     * A cart under thrust that changes now and then, by powers of what a drag (N s/m) takes from
     * one row to the next, which is next to nothing.
     */
    private static MeasuredRun run(double drag) {
        Random random = new Random(3);
        MeasuredRunBuilder run = MeasuredRun.named("run").commands(List.of("motor"));
        double lost = drag * SPACING / MASS;
        double x = 0;
        double v = 0;
        double level = 0;
        for (int k = 0; k < SAMPLES; k++) {
            level = k % 25 == 0 ? random.nextDouble(-1, 1) : level;
            double measured = x + NOISE * random.nextGaussian();
            run.at(k * SPACING).measured(Channel.POSITION, measured, Double.NaN, Double.NaN);
            run.command(0, level);
            double more = THRUST * level / MASS * SPACING;
            double kept = 1 - lost / 2 + lost * lost / 6;
            x += SPACING * (v * kept + more * (0.5 - lost / 6));
            v = v * (1 - lost + lost * lost / 2) + more * kept;
        }
        return run.build();
    }

    private static Search.Found found(double drag) throws Exception {
        return found(drag, List.of(new Cart(1, 1, 0).cause("linear_drag")));
    }

    private static Search.Found found(double drag, List<Cause> causes) throws Exception {
        return new Search(
                        Cart.believed(),
                        List.of(run(drag)),
                        causes,
                        Optional.empty(),
                        new Course(Progress.SILENT))
                .found();
    }

    private static double smallest() throws Exception {
        Search.Found found = found(0);
        assertThat(found.best().isNone()).isTrue();
        List<Smallest> smallest = found.traces().identifiability(List.of()).smallest();
        assertThat(smallest).hasSize(1);
        assertThat(smallest.getFirst().cause()).isEqualTo("linear_drag");
        assertThat(smallest.getFirst().unit()).isEqualTo("N s/m");
        return smallest.getFirst().size();
    }

    @Test
    void whatIsAsLargeIsFound() throws Exception {
        assertThat(found(smallest()).best().fit().hypothesis().causes())
                .extracting(Cause::id)
                .containsExactly("linear_drag");
    }

    @Test
    void whatIsMuchSmallerIsNot() throws Exception {
        assertThat(found(smallest() / 3).best().isNone()).isTrue();
    }

    /** What another cause's number makes up for does not show. */
    @Test
    void besideACauseThatDoesTheSameMoreIsMissed() throws Exception {
        Cart cart = new Cart(1, 1, 0);
        Cause linear = cart.cause("linear_drag");
        Cause quadratic = cart.cause("quadratic_drag");
        double alone = smallest();
        Search.Found beside = found(2 * alone, List.of(linear, quadratic));

        assertThat(beside.best().fit().hypothesis().causes()).containsExactly(linear);
        Smallest other = beside.traces().identifiability(List.of(linear)).smallest().getFirst();
        Smallest ofNone =
                found(0, List.of(quadratic))
                        .traces()
                        .identifiability(List.of())
                        .smallest()
                        .getFirst();
        assertThat(other.cause()).isEqualTo("quadratic_drag");
        assertThat(other.size()).isGreaterThan(1.5 * ofNone.size());
    }

    /** A cause that was found has its own number, and is not told again. */
    @Test
    void whatWasFoundIsNotMissed() throws Exception {
        Search.Found found = found(2 * smallest());

        assertThat(found.best().isNone()).isFalse();
        assertThat(
                        found.traces()
                                .identifiability(found.best().fit().hypothesis().causes())
                                .smallest())
                .isEmpty();
    }
}
