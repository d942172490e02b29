package org.auvsim.diagnosis.result;

import java.util.ArrayList;
import java.util.List;

/**
 * A verdict in one sentence for people.
 *
 * @param opening what is said of the model first
 * @param clauses what is added to that
 * @param scope the causes that it is said of
 */
public record Sentence(Opening opening, List<String> clauses, Scope scope) {
    private static final String DOUBT = "but the notices cast doubt on the data: read them first";

    /** The list cannot be changed. */
    public Sentence {
        clauses = List.copyOf(clauses);
    }

    /** Of all causes that are known. */
    public Sentence(Opening opening, List<String> clauses) {
        this(opening, clauses, Scope.KNOWN);
    }

    /** Words that are the same whichever causes were looked for. */
    public static Sentence of(String words) {
        return new Sentence(new Opening.Told(words), List.of());
    }

    /** In ASCII and without a full stop. */
    public String text() {
        List<String> parts = new ArrayList<>(clauses);
        parts.addFirst(opening.words(scope));
        String words = String.join("; ", parts);
        return scope == Scope.TRIED
                ? "Stopped before the end; the best so far: " + Phrases.inside(words)
                : words;
    }

    /** The same where the search was stopped before its end. */
    public Sentence stopped() {
        return new Sentence(opening, clauses, Scope.TRIED);
    }

    /** The same where only some causes were looked for; if it was stopped it is of fewer anyway. */
    public Sentence ofSome() {
        return scope == Scope.KNOWN ? new Sentence(opening, clauses, Scope.REQUESTED) : this;
    }

    /** The same of runs whose numbers may not be what they are taken for. */
    public Sentence doubted() {
        return clauses.contains(DOUBT) ? this : and(DOUBT);
    }

    /**
     * The same where another law of a drag that was found takes nearly as much away.
     *
     * @param otherLaw the cause's name
     * @param share of the misfit, 0 to 1
     */
    public Sentence unsettled(String otherLaw, double share) {
        return and(
                "the drag law is not settled: %s would remove %s of the misfit"
                        .formatted(otherLaw.replace('_', ' '), Numbers.percent(share)));
    }

    private Sentence and(String clause) {
        List<String> more = new ArrayList<>(clauses);
        more.add(clause);
        return new Sentence(opening, more, scope);
    }
}
