package org.auvsim.diagnosis.result;

/** How much was tried for a verdict: one of many that were compared says more than one of few. */
public final class Effort {
    private Effort() {}

    /** In words: {@code Causes looked for: 62; sets of them that were fitted: 23}. */
    public static String words(Diagnosis of) {
        long sets = of.ranked().stream().filter(set -> !set.causes().isEmpty()).count();
        String form =
                of.isComplete()
                        ? "Causes looked for: %d; sets of them that were fitted: %d"
                        : "Causes to be looked for: %d; sets of them that were fitted before the"
                                + " search was stopped: %d";
        return form.formatted(of.candidates(), sets);
    }
}
