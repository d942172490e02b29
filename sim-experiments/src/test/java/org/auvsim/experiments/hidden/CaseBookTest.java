package org.auvsim.experiments.hidden;

import static org.assertj.core.api.Assertions.assertThat;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.util.List;
import java.util.Objects;

class CaseBookTest {
    @ParameterizedTest
    @EnumSource(CaseKind.class)
    void aCaseHidesWhatItsKindSays(CaseKind kind) {
        HiddenCase of = CaseBook.draw(kind, 0.01, 3);

        assertThat(of.hidden())
                .hasSize(kind == CaseKind.NULL ? 0 : kind == CaseKind.PAIR ? 2 : 1)
                .allMatch(
                        e ->
                                kind == CaseKind.ALIAS
                                        || Effects.LIBRARY.containsKey(e.cause())
                                                != (kind == CaseKind.UNCOVERED));
        assertThat(of.fit()).hasSize(3);
        assertThat(of.heldOut()).hasSize(2);
        assertThat(of.twins().isPresent()).isEqualTo(kind == CaseKind.ALIAS);
        assertThat(of.model().variant().body().mass()).isPresent();
    }

    @Test
    void theSameSeedIsTheSameCaseAndNoiseIsAllThatNoiseChanges() {
        HiddenCase first = CaseBook.draw(CaseKind.SINGLE, 0.01, 5);
        HiddenCase again = CaseBook.draw(CaseKind.SINGLE, 0.01, 5);
        HiddenCase louder = CaseBook.draw(CaseKind.SINGLE, 0.05, 5);

        assertThat(x(again)).isEqualTo(x(first)).isNotEqualTo(x(louder));
        assertThat(again.hidden().toString())
                .isEqualTo(first.hidden().toString())
                .isEqualTo(louder.hidden().toString());
        assertThat(louder.truth()).isEqualTo(first.truth());
    }

    /** Its weight and its drag are then too much by one factor: nobody could tell. */
    @Test
    void aWrongMassIsNotHiddenInWhatOnlyFalls() {
        assertThat(fits("mass_error", new BallInAir())).isFalse();
        assertThat(fits("mass_error", new PushedBox())).isTrue();
        assertThat(fits("mass_error", new SphereInWater())).isTrue();
        assertThat(fits("quadratic_drag", new BallInAir())).isTrue();
    }

    private static boolean fits(String cause, Body body) {
        Draws draws = new Draws(1);
        Plant plant = body.plant(draws);
        Manoeuvre manoeuvre = body.manoeuvre(draws);
        List<Pose> still = List.of(new Pose(Vector3D.ZERO, Attitude.turned(Vector3D.ZERO)));
        Scene scene = Scene.of(plant, true, List.of(still), List.of(manoeuvre));
        return Objects.requireNonNull(Effects.LIBRARY.get(cause)).fits().test(scene);
    }

    private static double[] x(HiddenCase of) {
        MeasuredRun run = of.fit().getFirst();
        double[] x = new double[run.size()];
        for (int k = 0; k < x.length; k++) {
            x[k] = run.value(Channel.POSITION, k, 0);
        }
        return x;
    }
}
