package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.result.Identifiability.Smallest;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

import java.util.List;

/** Of a cart that lacks nothing it is told how much it could lack without being found out. */
class SmallestTest {
    private static Search.Found found(double drag) throws Exception {
        Cart cart = cart(drag);
        return cart.found(List.of(cart.cause("linear_drag")));
    }

    private static Cart cart(double drag) {
        return new Cart(1, drag, 0);
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
        Cart cart = cart(2 * smallest());
        Cause linear = cart.cause("linear_drag");
        Cause quadratic = cart.cause("quadratic_drag");
        Search.Found beside = cart.found(List.of(linear, quadratic));

        assertThat(beside.best().fit().hypothesis().causes()).containsExactly(linear);
        Smallest other = beside.traces().identifiability(List.of(linear)).smallest().getFirst();
        Smallest ofNone =
                cart(0).found(List.of(quadratic))
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
