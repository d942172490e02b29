package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.result.Alternative;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** Other sets of causes that explain the runs about as well as the best. */
public final class Alternatives {
    /** Models whose motions differ by less (squared, in standard deviations) are the same here. */
    private static final double SAME = 9;

    private static final double MARGIN = 12;
    private static final int MOST = 6;

    /**
     * Twice the logarithm of odds from which evidence is positive (Kass and Raftery 1995): so much
     * more likely a common cause is than another one before anything was measured.
     */
    private static final double POSITIVE = 2;

    private Alternatives() {}

    /**
     * Those of the best, nearest first. Beside specific causes, those that can imitate others are
     * told where they predict the very same, or explain the runs better.
     */
    static List<Judged> competitors(Judged best, List<Judged> judged) {
        boolean isGeneric = best.fit().hypothesis().isGeneric();
        List<List<Cause>> taken = new ArrayList<>();
        taken.add(best.fit().hypothesis().causes());
        List<Judged> competitors = new ArrayList<>();
        for (Judged other : judged) {
            List<Cause> causes = other.fit().hypothesis().causes();
            boolean isNear = other.score() < best.score() + MARGIN;
            boolean isPlain = !other.fit().hypothesis().isGeneric() || isGeneric;
            boolean isBetter = other.score() < best.score();
            if (isNear
                    && !contains(causes, best)
                    && !taken.contains(causes)
                    && (isPlain || isBetter || areSame(best, other))) {
                taken.add(causes);
                competitors.add(other);
            }
        }
        return List.copyOf(competitors.subList(0, Math.min(MOST, competitors.size())));
    }

    /** One that has all causes of the best in some form, and more, is no alternative to it. */
    private static boolean contains(List<Cause> causes, Judged best) {
        return best.fit().hypothesis().causes().stream()
                .allMatch(own -> causes.stream().anyMatch(own::isFormOf));
    }

    /**
     * Of what the data cannot tell apart from the best, with one number more at most, that whose
     * causes stand first in the library, where the common ones do.
     */
    public static Judged commonest(Judged best, List<Judged> competitors, List<Cause> library) {
        Judged first = best;
        for (Judged other : competitors) {
            boolean isTied = misfit(other) - misfit(best) < POSITIVE && areSame(best, other);
            if (isTied && isAsPlain(other, best) && isBefore(other, first, library)) {
                first = other;
            }
        }
        return first;
    }

    private static double misfit(Judged judged) {
        return judged.score() - judged.price();
    }

    private static boolean isAsPlain(Judged other, Judged best) {
        Hypothesis of = other.fit().hypothesis();
        return of.size() <= best.fit().hypothesis().size() + 1
                && of.causes().size() == best.size()
                && (!of.isGeneric() || best.fit().hypothesis().isGeneric());
    }

    private static boolean isBefore(Judged a, Judged b, List<Cause> library) {
        return Arrays.compare(places(a, library), places(b, library)) < 0;
    }

    /** Where its causes stand in the library, the first of them first. */
    private static int[] places(Judged of, List<Cause> library) {
        return of.fit().hypothesis().causes().stream()
                .mapToInt(library::indexOf)
                .sorted()
                .toArray();
    }

    /** Another one that explains the runs about as well, as what is told of it beside the best. */
    public static Alternative alternative(Judged best, Judged other) {
        boolean isSame = areSame(best, other);
        return new Alternative(
                other.fit().hypothesis().causes().stream().map(Cause::label).toList(),
                isSame,
                isSame ? determined(best.fit().hypothesis(), other.fit().hypothesis()) : "",
                isSame ? new Unmeasured(best, other).words() : "");
    }

    /** Whether two models predict the same of the runs, within their noise. */
    public static boolean areSame(Judged a, Judged b) {
        return distance(a, b) < SAME;
    }

    /** Squared difference of what two models predict of the runs, in standard deviations. */
    static double distance(Judged a, Judged b) {
        double sum = 0;
        for (int r = 0; r < a.outcome().misses().size(); r++) {
            double[] one = a.outcome().misses().get(r);
            double[] other = b.outcome().misses().get(r);
            for (int i = 0; i < one.length; i++) {
                sum += (one[i] - other[i]) * (one[i] - other[i]);
            }
        }
        return sum;
    }

    /** What may be instead of each other, where each has one number of its own; else empty. */
    private static String determined(Hypothesis best, Hypothesis other) {
        Optional<Amount> a = onlyOne(best, other);
        Optional<Amount> b = onlyOne(other, best);
        return a.isPresent() && b.isPresent() ? Barter.words(a.get(), b.get()) : "";
    }

    /** The number of the causes that the other hypothesis has not, if it is only one. */
    private static Optional<Amount> onlyOne(Hypothesis of, Hypothesis other) {
        List<Cause> own = new ArrayList<>(of.causes());
        own.removeAll(other.causes());
        if (own.size() != 1) {
            return Optional.empty();
        }
        double[] theta = of.theta().get(of.causes().indexOf(own.getFirst()));
        return own.getFirst().quantities(theta).size() == 1
                ? Optional.of(Amount.of(own.getFirst(), theta, 0))
                : Optional.empty();
    }
}
