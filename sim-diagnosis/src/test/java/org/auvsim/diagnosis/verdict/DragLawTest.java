package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.run.LastingError;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.result.Alternative;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.search.Search;
import org.auvsim.diagnosis.search.Way;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

import java.util.List;

/** A cart with linear drag, whose speeds do not differ much. */
class DragLawTest {
    private static final Cart CART = new Cart(1, 2, 0);

    private static Search.Found found(MeasuredRun run) throws Exception {
        List<Cause> laws = List.of(CART.cause("linear_drag"), CART.cause("quadratic_drag"));
        Course course = new Course(Progress.SILENT);
        return new Search(Cart.believed(), List.of(run), laws, Way.THOROUGH, course).found();
    }

    private static MeasuredRun erring() {
        return CART.run(new LastingError(0.05, 5));
    }

    @Test
    void byMeasurementsWhoseErrorsLastTheLawIsNotSettled() throws Exception {
        Search.Found found = found(erring());

        assertThat(found.best().fit().hypothesis().causes())
                .extracting(Cause::name)
                .containsExactly("linear_drag");
        assertThat(DragLaw.unsettled(found, List.of()))
                .hasValueSatisfying(
                        other -> {
                            assertThat(other.cause()).isEqualTo("quadratic_drag");
                            assertThat(other.share()).isBetween(0.9, 0.9999);
                        });
    }

    @Test
    void itIsByThoseWhoseErrorsAreStatedToBeNoise() throws Exception {
        assertThat(DragLaw.unsettled(found(CART.run()), List.of())).isEmpty();
    }

    @Test
    void whatIsToldAsAnAlternativeIsNotToldAgain() throws Exception {
        Alternative told = new Alternative(List.of("quadratic_drag"), true, "", "");

        assertThat(DragLaw.unsettled(found(erring()), List.of(told))).isEmpty();
    }
}
