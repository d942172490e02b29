package org.auvsim.diagnosis.result;

import org.auvsim.diagnosis.run.Channel;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collector;
import java.util.stream.Collectors;

/** Puts what was found into sentences. */
public final class Sentences {
    private static final Collector<CharSequence, ?, String> AND = Collectors.joining(" and ");

    /** Of those that cannot be told from what was found so many are named; the page has all. */
    private static final int MOST_OTHERS = 1;

    private final Optional<ToldError> error;
    private final boolean isGained;
    private final Moments moments;

    /**
     * Sentences that also tell the error on held-out runs.
     *
     * @param gains by channel; that of the position is told, or else the first, unless another one
     *     alone gains
     * @param usedHeldOut whether it is that of leaving each run out in turn
     * @param isGained whether what was found makes it smaller, by more than chance
     */
    public Sentences(Map<Channel, Gain> gains, boolean usedHeldOut, boolean isGained) {
        this(ToldError.of(gains, usedHeldOut), gains.isEmpty() || isGained, Moments.PLAIN);
    }

    private Sentences(Optional<ToldError> error, boolean isGained, Moments moments) {
        this.error = error;
        this.isGained = isGained;
        this.moments = moments;
    }

    /** The same with times as these runs have them. */
    public Sentences with(Moments other) {
        return new Sentences(error, isGained, other);
    }

    /** The search was stopped before it had fitted any cause. */
    public static Sentence stoppedAtOnce() {
        return Sentence.of(
                "Stopped before any cause was fitted: nothing can be said of the model yet");
    }

    /**
     * The body shakes more than in reference runs, and moves as its model has it.
     *
     * @param found by how many times
     */
    public static Sentence shaking(Finding found, int references) {
        return Sentence.of(
                "The vehicle shakes %s as much as in the %d reference runs, and moves as the model has it: a propeller is out of balance, or damaged"
                        .formatted(QuantityGroup.of(found).getFirst().text(), references));
    }

    /** Nothing is wrong that shows. */
    public Sentence none() {
        return new Sentence(new Opening.Nothing(), error.map(ToldError::before).stream().toList());
    }

    /** No known cause explains the runs. */
    public Sentence unexplained(Optional<Discrepancy> discrepancy) {
        List<String> clauses = new ArrayList<>();
        error.map(ToldError::change).ifPresent(clauses::add);
        if (error.filter(ToldError::isWorse).isPresent()) {
            clauses.add("these causes make the prediction worse");
        }
        return new Sentence(new Opening.Something(discrepancy.map(this::known)), clauses);
    }

    private Opening.Known known(Discrepancy of) {
        String frequency =
                of.frequency().isPresent()
                        ? ", mostly at %s Hz"
                                .formatted(Numbers.rounded(of.frequency().getAsDouble()))
                        : "";
        return new Opening.Known(
                "the %s, at %s%s"
                        .formatted(
                                of.axis().within(of.channel()),
                                moments.text(of.time(), of.run()),
                                frequency),
                of.share());
    }

    /**
     * Causes explain the runs.
     *
     * @param share of the misfit beyond noise that they take away together, 0 to 1
     * @param alternatives the most probable first
     */
    public Sentence explained(List<Finding> found, double share, List<Alternative> alternatives) {
        boolean isOne = found.size() == 1;
        List<String> clauses = new ArrayList<>();
        clauses.add(
                "%s %s of the misfit"
                        .formatted(
                                isOne ? "it explains" : "together they explain",
                                Numbers.percent(share)));
        error.map(ToldError::change).ifPresent(clauses::add);
        if (!isGained) {
            clauses.add(
                    "but begun otherwise these runs are predicted just as well without "
                            + (isOne ? "it" : "them"));
        }
        clauses.addAll(aliases(found, alternatives));
        return new Sentence(new Opening.Told(causes(found)), clauses);
    }

    private String causes(List<Finding> found) {
        List<String> parts = found.stream().map(this::part).toList();
        String causes = parts.getFirst();
        for (String part : parts.subList(1, parts.size())) {
            causes += ", and " + Phrases.inside(part);
        }
        return causes;
    }

    private String part(Finding finding) {
        List<QuantityGroup> groups = QuantityGroup.of(finding);
        if (groups.isEmpty()) {
            return Phrases.of(finding);
        }
        String numbers =
                groups.size() == 1
                        ? OnlyNumber.text(finding, groups.getFirst())
                        : groups.stream()
                                .map(group -> group.name() + " " + moments.text(group))
                                .collect(Collectors.joining(", "));
        return Phrases.of(finding) + ": " + numbers;
    }

    /** Clauses of what cannot be told from what was found. */
    private static List<String> aliases(List<Finding> found, List<Alternative> alternatives) {
        List<Alternative> same =
                alternatives.stream().filter(Alternative::isIndistinguishable).toList();
        if (same.isEmpty()) {
            return List.of();
        }
        List<Alternative> named = same.subList(0, Math.min(MOST_OTHERS, same.size()));
        List<String> shared = shared(found, named);
        String chosen =
                found.stream()
                        .filter(finding -> !shared.contains(finding.name()))
                        .map(Phrases::of)
                        .map(Phrases::inside)
                        .collect(AND);
        String others =
                named.stream()
                        .map(other -> other.causes().stream().filter(c -> !shared.contains(c)))
                        .map(causes -> causes.map(Phrases::of).map(Phrases::inside).collect(AND))
                        .collect(Collectors.joining(", or "));
        List<String> clauses = new ArrayList<>();
        clauses.add(
                "this data cannot tell apart: %s, or %s%s"
                        .formatted(chosen, others, more(same.size() - named.size())));
        String determined =
                named.stream()
                        .map(Alternative::determined)
                        .filter(words -> !words.isBlank())
                        .distinct()
                        .collect(Collectors.joining(", "));
        if (!determined.isEmpty()) {
            clauses.add("it could be " + determined);
        }
        return clauses;
    }

    /** What all of them have, if each has something beside it: that is not in question. */
    private static List<String> shared(List<Finding> found, List<Alternative> others) {
        List<String> shared =
                found.stream()
                        .map(Finding::name)
                        .filter(name -> others.stream().allMatch(o -> o.causes().contains(name)))
                        .toList();
        boolean isAllOfOne =
                shared.size() == found.size()
                        || others.stream().anyMatch(o -> o.causes().size() == shared.size());
        return isAllOfOne ? List.of() : shared;
    }

    private static String more(int sets) {
        return sets == 0
                ? ""
                : ", and %d more set%s of causes".formatted(sets, sets == 1 ? "" : "s");
    }
}
