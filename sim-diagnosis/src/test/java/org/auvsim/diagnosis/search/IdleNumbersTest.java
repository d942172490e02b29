package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

import java.util.List;

/** Of a body that moves along one line, a vector has two numbers that do nothing. */
class IdleNumbersTest {
    private static final Cart HEAVIER = new Cart(0.8, 1e-6, 0);

    @Test
    void addedMassIsAsProbableAsMassWhereTheyAreTheSame() throws Exception {
        Search.Found found =
                HEAVIER.found(List.of(HEAVIER.cause("mass_error"), HEAVIER.cause("added_mass")));

        Judged mass = found.best();
        assertThat(id(mass)).isEqualTo("mass_error");
        assertThat(found.competitors()).hasSize(1);
        Judged added = found.competitors().getFirst();
        assertThat(id(added)).isEqualTo("added_mass");
        assertThat(added.told()).isOne();
        assertThat(added.logEvidence()).isCloseTo(mass.logEvidence(), within(0.5));
        assertThat(Alternatives.areSame(mass, added)).isTrue();
    }

    private static String id(Judged judged) {
        return judged.fit().hypothesis().causes().getFirst().id();
    }
}
