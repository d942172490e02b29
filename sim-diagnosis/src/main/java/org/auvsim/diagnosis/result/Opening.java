package org.auvsim.diagnosis.result;

import java.util.Optional;

/** What a sentence says of a model first. */
public sealed interface Opening {
    /** In words, from a capital on. */
    String words(Scope of);

    /**
     * What is the same whichever causes were looked for, as what was found.
     *
     * @param text as it is told
     */
    record Told(String text) implements Opening {
        @Override
        public String words(Scope of) {
            return text;
        }
    }

    /** Nothing is missing that shows. */
    record Nothing() implements Opening {
        @Override
        public String words(Scope of) {
            return of == Scope.TRIED
                    ? "The model as it is; no cause tried so far gains enough"
                    : "This data shows nothing missing from the model";
        }
    }

    /**
     * Something is missing that no cause explains.
     *
     * @param known what is known of it
     */
    record Something(Optional<Known> known) implements Opening {
        @Override
        public String words(Scope of) {
            String none =
                    switch (of) {
                        case KNOWN -> "no known cause";
                        case REQUESTED -> "none of the requested causes";
                        case TRIED -> "no cause tried so far";
                    };
            return "The model lacks something that %s explains%s"
                    .formatted(none, known.map(what -> "; " + what.words(of)).orElse(""));
        }
    }

    /**
     * What is known of a misfit.
     *
     * @param where it shows most, as {@code the position along x, at 3.00 s of run1}; where causes
     *     take some of it away, what they leave
     * @param share of it that the best causes take away, 0 to 1
     */
    record Known(String where, double share) {
        String words(Scope of) {
            boolean isOfAll = of == Scope.KNOWN;
            return share > 0
                    ? "%s remove %s of it, and what they leave shows most in %s"
                            .formatted(
                                    isOfAll ? "the best known causes" : "the best of these",
                                    Numbers.percent(share),
                                    where)
                    : "it shows most in %s; %s removes enough of it to be believed"
                            .formatted(where, isOfAll ? "no cause" : "none of these");
        }
    }
}
