package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Set;

/** Of a body that moves along one line, a vector has two numbers that do nothing. */
class IdleNumbersTest {
    private static final Cart HEAVIER = new Cart(0.8, 1e-6, 0);
    private static final Set<String> IDS = Set.of("mass_error", "added_mass");

    private static Search.Found found() throws Exception {
        BelievedModel onRails = Cart.onRails();
        List<MeasuredRun> runs = List.of(HEAVIER.run());
        List<Cause> causes =
                Library.of(onRails, runs).stream().filter(c -> IDS.contains(c.id())).toList();
        Course course = new Course(Progress.SILENT);
        return new Search(onRails, runs, causes, Way.THOROUGH, course).found();
    }

    @Test
    void addedMassIsAsProbableAsMassWhereTheyAreTheSame() throws Exception {
        Search.Found found = found();

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
