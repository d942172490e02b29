package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.result.Alternative;
import org.auvsim.diagnosis.search.Search;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * How sure the law of a drag is. That a force grows with the speed, or with its square, are two
 * ends of what a real body feels (by Reynolds number: Hoerner, Fluid-Dynamic Drag, 1965, chapter
 * 3). Where errors of measurements last, evidence for one against the other is as sure as what was
 * stated of these errors, which is a guess: a law that takes nearly as much away is not ruled out.
 */
final class DragLaw {
    /** The other law is not ruled out if it takes away this share of what the first does. */
    private static final double NEARLY = 0.9;

    private static final String LINEAR = "linear_drag";
    private static final String QUADRATIC = "quadratic_drag";

    private static final Map<String, String> OTHER = Map.of(LINEAR, QUADRATIC, QUADRATIC, LINEAR);

    private DragLaw() {}

    /** Whether two sets differ in the law of a drag alone. */
    static boolean isAllTheyDifferIn(Judged one, Judged other) {
        return OTHER.entrySet().stream()
                .filter(law -> names(one).contains(law.getKey()))
                .anyMatch(law -> names(other).equals(instead(names(one), law)));
    }

    /**
     * The other law.
     *
     * @param cause its name
     * @param share of the misfit that it takes away, with the other causes that were found
     */
    record Other(String cause, double share) {}

    /** The other law, if it is not ruled out; nor is it told if it is an alternative anyway. */
    static Optional<Other> unsettled(Search.Found found, List<Alternative> alternatives) {
        Judged best = found.best();
        boolean isTold =
                alternatives.stream()
                        .flatMap(other -> other.causes().stream())
                        .anyMatch(name -> OTHER.containsKey(name) && !names(best).contains(name));
        if (isTold || best.fit().data().stream().noneMatch(Misses::hasLastingErrors)) {
            return Optional.empty();
        }
        double share = Findings.share(found.none(), best);
        return OTHER.entrySet().stream()
                .filter(law -> names(best).contains(law.getKey()))
                .filter(law -> !names(best).contains(law.getValue()))
                .flatMap(
                        law ->
                                found.judged().stream()
                                        .filter(j -> names(j).equals(instead(names(best), law)))
                                        .map(j -> Findings.share(found.none(), j))
                                        .filter(other -> other >= NEARLY * share)
                                        .map(other -> new Other(law.getValue(), other)))
                .findFirst();
    }

    private static Set<String> instead(Set<String> names, Map.Entry<String, String> law) {
        Set<String> other = new HashSet<>(names);
        other.remove(law.getKey());
        other.add(law.getValue());
        return other;
    }

    private static Set<String> names(Judged judged) {
        Set<String> names = new HashSet<>();
        judged.fit().hypothesis().causes().stream().map(Cause::name).forEach(names::add);
        return names;
    }
}
