package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Ranked;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.subject.Cart;
import org.auvsim.diagnosis.verdict.Examination;
import org.auvsim.diagnosis.verdict.Ranking;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * A motor that is weaker than believed, in a drag and a current that the model lacks: three causes,
 * of which the first can as well be a larger mass.
 */
class AliasTest {
    private static final Cart CART = new Cart(0.8, 3, 0.4);
    private static Search.Found found;

    @BeforeAll
    static void theCartIsDiagnosed() throws Exception {
        found =
                CART.found(
                        List.of(
                                CART.cause("thruster_gain"),
                                CART.cause("mass_error"),
                                CART.cause("linear_drag"),
                                CART.cause("current_constant")));
    }

    private static Set<String> ids(Judged judged) {
        Set<String> ids = new HashSet<>();
        judged.fit().hypothesis().causes().forEach(cause -> ids.add(cause.id()));
        return ids;
    }

    @Test
    void whatCannotBeToldApartIsTriedHoweverManyCausesThereAre() {
        Set<String> gain = Set.of("thruster_gain", "linear_drag", "current_constant");
        Set<String> mass = Set.of("mass_error", "linear_drag", "current_constant");

        assertThat(ids(found.best())).isEqualTo(gain); // the first in the library
        Judged alias =
                found.competitors().stream()
                        .filter(judged -> ids(judged).equals(mass))
                        .findFirst()
                        .orElseThrow();
        assertThat(Alternatives.alternative(found.best(), alias).isIndistinguishable()).isTrue();
    }

    /** Of runs with a drag that is not looked for, weak motors and masses explain as little. */
    @Test
    void whatExplainsNothingHasNoAlternatives() throws Exception {
        Cart slow = new Cart(0.8, 0.01, 0);
        List<MeasuredRun> runs = List.of(slow.run());
        List<Cause> causes = List.of(slow.cause("thruster_gain"), slow.cause("mass_error"));

        Diagnosis diagnosis =
                new Examination(
                                Cart.believed(),
                                runs,
                                runs,
                                causes,
                                1,
                                Way.THOROUGH,
                                Progress.SILENT)
                        .diagnosis();

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.UNEXPLAINED);
        assertThat(slow.found(causes).competitors()).isNotEmpty();
        assertThat(diagnosis.evidence().alternatives()).isEmpty();
    }

    /** Whoever sees it behind a set of less evidence is told why. */
    @Test
    void whatIsRankedBehindLessEvidenceSaysWhy() {
        List<Ranked> ranked = Ranking.of(found, true);
        double chosen = ranked.getFirst().logEvidence();

        assertThat(ranked.getFirst().behind()).isEmpty();
        assertThat(ranked.subList(1, ranked.size()))
                .allMatch(set -> set.behind().isPresent() == set.logEvidence() > chosen)
                .anyMatch(set -> set.behind().isEmpty());
        Search.Found other = found.nothing();
        assertThat(Ranking.of(other, true).getFirst().name()).isEqualTo("none");
        assertThat(Ranking.of(other, true).get(1).behind())
                .contains("held-out runs do not confirm it, or noise alone could gain as much");
    }

    /** A score also has the price of many tries. */
    @Test
    void behindWhatWasChosenMostEvidenceComesFirst() {
        List<Judged> turned = new ArrayList<>(found.judged()).reversed();
        Search.Found other =
                new Search.Found(
                        found.none(),
                        found.best(),
                        turned,
                        found.competitors(),
                        found.traces(),
                        found.noise(),
                        found.byRun(),
                        found.misreading());
        List<Ranked> ranked = Ranking.of(other, true);

        assertThat(ranked).hasSameSizeAs(Ranking.of(found, true));
        assertThat(ranked.subList(1, ranked.size()))
                .isSortedAccordingTo(Comparator.comparingDouble(Ranked::logEvidence).reversed());
    }

    /** What explains nothing has no place of its own; which one errors are told of is seen. */
    @Test
    void whereNothingWasChosenMostEvidenceComesFirst() {
        List<Ranked> ranked = Ranking.of(found.nothing(), false);

        assertThat(ranked)
                .isSortedAccordingTo(Comparator.comparingDouble(Ranked::logEvidence).reversed());
        assertThat(ranked.getFirst().causes()).isNotEmpty();
        assertThat(ranked.stream().filter(set -> set.behind().isEmpty()).findFirst())
                .map(Ranked::name)
                .contains("none");
    }

    /** Of the cart only the way ahead is measured. */
    @Test
    void whatTheDataDoesNotDetermineHasNoNumber() {
        List<Quantity> current =
                Ranking.of(found, true).stream()
                        .filter(set -> set.causes().contains("current_constant"))
                        .map(set -> set.quantities().get(set.causes().indexOf("current_constant")))
                        .findFirst()
                        .orElseThrow();

        assertThat(current).extracting(Quantity::name).containsExactly("u.x", "u.y", "u.z");
        assertThat(current.stream().map(of -> Double.isNaN(of.value())))
                .containsExactly(false, true, true);
    }

    @Test
    void aSetOfCausesIsRankedOnce() {
        assertThat(found.judged()).extracting(AliasTest::ids).doesNotHaveDuplicates();
    }
}
