package org.auvsim.diagnosis.result;

import org.auvsim.diagnosis.run.Channel;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collector;
import java.util.stream.Collectors;

/** Says a verdict in one sentence for people, in ASCII and without a full stop. */
public final class Sentence {
    private static final Collector<CharSequence, ?, String> AND = Collectors.joining(" and ");
    private static final String NOTHING = "This data shows nothing missing from the model";
    private static final String SOMETHING =
            "The model lacks something that no known cause explains";
    private static final String BEST = "; the best known causes remove ";
    private static final String BEST_OF_THESE = "; the best of these remove ";
    private static final String LEFT = " of it, and what they leave shows most in ";
    private static final String NO_CAUSE = "; no cause removes enough of it to be believed";
    private static final String NONE_OF_THESE =
            "; none of these removes enough of it to be believed";

    /** An error that is so many times another one is worse, and not by chance. */
    private static final double WORSE = 1.1;

    /** Of those that cannot be told from what was found so many are named; the page has all. */
    private static final int MOST_OTHERS = 1;

    private static final String NO_GAIN = "; but these runs are predicted just as well without ";

    private final Optional<Map.Entry<Channel, Gain>> error;
    private final String runs;
    private final boolean isGained;
    private final Moments moments;

    /**
     * A sentence that also tells the error on held-out runs.
     *
     * @param heldOut by channel; that of the position is told, or else the first, unless another
     *     one alone gains
     * @param usedHeldOut whether it is that of leaving each run out in turn
     * @param isGained whether what was found makes it smaller, by more than chance
     */
    public Sentence(Map<Channel, Gain> heldOut, boolean usedHeldOut, boolean isGained) {
        this(
                telling(heldOut),
                usedHeldOut ? "left-out" : "held-out",
                heldOut.isEmpty() || isGained,
                Moments.PLAIN);
    }

    private Sentence(
            Optional<Map.Entry<Channel, Gain>> error,
            String runs,
            boolean isGained,
            Moments moments) {
        this.error = error;
        this.runs = runs;
        this.isGained = isGained;
        this.moments = moments;
    }

    /** The same with times as these runs have them. */
    public Sentence with(Moments other) {
        return new Sentence(error, runs, isGained, other);
    }

    private static Optional<Map.Entry<Channel, Gain>> telling(Map<Channel, Gain> heldOut) {
        List<Map.Entry<Channel, Gain>> all =
                heldOut.entrySet().stream().sorted(Map.Entry.comparingByKey()).toList();
        Optional<Map.Entry<Channel, Gain>> first = all.stream().findFirst();
        return all.stream().filter(e -> isGain(e.getValue())).findFirst().or(() -> first);
    }

    private static boolean isGain(Gain gain) {
        return WORSE * gain.after() < gain.before();
    }

    /**
     * Causes explain the runs.
     *
     * @param share of the misfit beyond noise that they take away together, 0 to 1
     * @param alternatives the most probable first
     */
    public String explained(List<Finding> found, double share, List<Alternative> alternatives) {
        List<String> parts = found.stream().map(this::part).toList();
        String causes = parts.getFirst();
        for (String part : parts.subList(1, parts.size())) {
            causes += ", and " + Phrases.inside(part);
        }
        String explains = found.size() == 1 ? "it explains" : "together they explain";
        return "%s; %s %s of the misfit%s%s%s"
                .formatted(
                        causes,
                        explains,
                        Numbers.percent(share),
                        gain(),
                        isGained ? "" : NO_GAIN + (found.size() == 1 ? "it" : "them"),
                        aliases(found, alternatives));
    }

    /**
     * The same where another law of its drag takes nearly as much away.
     *
     * @param otherLaw the cause's name
     * @param share of the misfit, 0 to 1
     */
    public static String unsettled(String explained, String otherLaw, double share) {
        return "%s; the drag law is not settled: %s would remove %s of the misfit"
                .formatted(explained, otherLaw.replace('_', ' '), Numbers.percent(share));
    }

    /**
     * The body shakes more than in reference runs, and moves as its model has it.
     *
     * @param found by how many times
     */
    public static String shaking(Finding found, int references) {
        return "The vehicle shakes %s as much as in the %d reference runs, and moves as the model has it: a propeller is out of balance, or damaged"
                .formatted(QuantityGroup.of(found).getFirst().text(), references);
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

    private static String aliases(List<Finding> found, List<Alternative> alternatives) {
        List<Alternative> same =
                alternatives.stream().filter(Alternative::isIndistinguishable).toList();
        if (same.isEmpty()) {
            return "";
        }
        String chosen = found.stream().map(Phrases::of).map(Phrases::inside).collect(AND);
        String others =
                same.stream()
                        .limit(MOST_OTHERS)
                        .map(Alternative::causes)
                        .map(names -> names.stream().map(Phrases::of).map(Phrases::inside))
                        .map(phrases -> phrases.collect(AND))
                        .collect(Collectors.joining(", or "));
        int more = Math.max(0, same.size() - MOST_OTHERS);
        String determined =
                same.stream()
                        .limit(MOST_OTHERS)
                        .map(Alternative::determined)
                        .filter(words -> !words.isBlank())
                        .distinct()
                        .collect(Collectors.joining(", "));
        return "; this data cannot tell apart: %s, or %s%s%s"
                .formatted(
                        chosen,
                        others,
                        more == 0
                                ? ""
                                : ", and %d more set%s of causes"
                                        .formatted(more, more == 1 ? "" : "s"),
                        determined.isEmpty() ? "" : "; it could be " + determined);
    }

    /** Nothing is wrong that shows. */
    public String none() {
        return NOTHING
                + error.map(
                                e ->
                                        "; %s %s error %s, noise is %s"
                                                .formatted(
                                                        runs,
                                                        words(e.getKey()),
                                                        text(e, e.getValue().before()),
                                                        text(e, e.getValue().noise())))
                        .orElse("");
    }

    /** No known cause explains the runs. */
    public String unexplained(Optional<Discrepancy> discrepancy) {
        boolean isWorse =
                error.filter(e -> e.getValue().after() > WORSE * e.getValue().before()).isPresent();
        return SOMETHING
                + discrepancy.map(this::known).orElse("")
                + gain()
                + (isWorse ? "; these causes make the prediction worse" : "");
    }

    /**
     * What one of these sentences still says when the search was stopped before its end: nothing of
     * causes that were not tried.
     */
    public static String stopped(String sentence) {
        return "Stopped before the end; the best so far: "
                + Phrases.inside(
                        sentence.replace(
                                        NOTHING,
                                        "The model as it is; no cause tried so far gains enough")
                                .replace(
                                        SOMETHING,
                                        "The model lacks something that no cause tried so far"
                                                + " explains")
                                .replace(BEST, BEST_OF_THESE)
                                .replace(NO_CAUSE, NONE_OF_THESE));
    }

    /** The same where the search was stopped before it had fitted any cause. */
    public static String stoppedAtOnce() {
        return "Stopped before any cause was fitted: nothing can be said of the model yet";
    }

    /** What one of these sentences still says when only some causes were looked for. */
    public static String ofSome(String sentence) {
        return sentence.replace(
                        SOMETHING,
                        "The model lacks something that none of the requested causes explains")
                .replace(BEST, BEST_OF_THESE)
                .replace(NO_CAUSE, NONE_OF_THESE);
    }

    /** The same of runs whose numbers may not be what they are taken for. */
    public static String doubted(String sentence) {
        return sentence + "; but the notices cast doubt on the data: read them first";
    }

    private String known(Discrepancy of) {
        String frequency =
                of.frequency().isPresent()
                        ? ", mostly at %s Hz"
                                .formatted(Numbers.rounded(of.frequency().getAsDouble()))
                        : "";
        String where =
                "the %s, at %s%s"
                        .formatted(
                                of.axis().within(of.channel()),
                                moments.text(of.time(), of.run()),
                                frequency);
        return of.share() > 0
                ? BEST + Numbers.percent(of.share()) + LEFT + where
                : "; it shows most in " + where + NO_CAUSE;
    }

    private String gain() {
        return error.map(
                        e ->
                                "; %s %s error %s -> %s, noise is %s"
                                        .formatted(
                                                runs,
                                                words(e.getKey()),
                                                text(e, e.getValue().before()),
                                                text(e, e.getValue().after()),
                                                text(e, e.getValue().noise())))
                .orElse("");
    }

    private static String text(Map.Entry<Channel, Gain> of, double value) {
        return Numbers.rounded(value) + " " + unit(of.getKey());
    }

    /** A channel's name for people. */
    public static String words(Channel channel) {
        return switch (channel) {
            case POSITION -> "position";
            case ORIENTATION -> "orientation";
            case VELOCITY -> "velocity";
            case ANGULAR_VELOCITY -> "angular velocity";
        };
    }

    /** The unit of a channel's numbers. */
    public static String unit(Channel channel) {
        return switch (channel) {
            case POSITION -> "m";
            case ORIENTATION -> "rad";
            case VELOCITY -> "m/s";
            case ANGULAR_VELOCITY -> "rad/s";
        };
    }
}
