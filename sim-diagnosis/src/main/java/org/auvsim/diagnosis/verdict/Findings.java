package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Uncertainty;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.search.Search;
import org.auvsim.diagnosis.search.Told;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;

/** The causes of what was found, and what each of them explains. */
final class Findings {
    private Findings() {}

    /** A finding, and how much worse all is without it. */
    private record Weighed(Finding finding, double loss) {}

    /** What explains the runs, the cause first without which they are explained worst. */
    static List<Finding> of(Search.Found found) {
        return of(found, new Uncertainty(found.best()).deviations());
    }

    /** What explains nothing: without deviations, for there is no model that they would be of. */
    static List<Finding> unsure(Search.Found found) {
        int causes = found.best().size();
        return of(found, Collections.nCopies(causes, List.of()));
    }

    private static List<Finding> of(Search.Found found, List<List<Double>> deviations) {
        Judged best = found.best();
        Hypothesis hypothesis = best.fit().hypothesis();
        Variant believed = best.fit().stepping().variant();
        List<Weighed> findings = new ArrayList<>();
        for (int c = 0; c < hypothesis.causes().size(); c++) {
            Cause cause = hypothesis.causes().get(c);
            Judged without = found.without(c);
            Finding finding =
                    new Finding(
                            cause.id(),
                            cause.subject(),
                            deviations.get(c).isEmpty()
                                    ? Told.of(cause, hypothesis.theta().get(c))
                                    : cause.quantities(hypothesis.theta().get(c)),
                            deviations.get(c),
                            share(found.none(), without, best),
                            !cause.in(believed, hypothesis.theta().get(c)).movesAs(believed));
            findings.add(new Weighed(finding, without.score()));
        }
        return findings.stream()
                .sorted(Comparator.comparingDouble(Weighed::loss).reversed())
                .map(Weighed::finding)
                .toList();
    }

    /** Share of the squares beyond noise that goes from the model as it is believed to a fit. */
    static double share(Judged none, Judged with) {
        return share(none, none, with);
    }

    /**
     * Share of the squares beyond noise of the model as it is believed that goes from one fit to a
     * better one. Errors that last belong to what is missed, and not to the noise, which is no
     * larger than what is left.
     */
    private static double share(Judged none, Judged without, Judged with) {
        double left = with.fit().squares();
        double noise = Math.min(left, with.outcome().count());
        double all = Math.max(none.fit().squares() - noise, 0);
        double gone = without.fit().squares() - left;
        if (gone == Double.POSITIVE_INFINITY) {
            return 1;
        }
        return all > 0 ? Math.clamp(gone / all, 0, 1) : 0;
    }
}
