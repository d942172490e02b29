package org.auvsim.diagnosis.report;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.result.Approximation;
import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Discrepancy;
import org.auvsim.diagnosis.result.Effort;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Moments;
import org.auvsim.diagnosis.result.NextExperiment;
import org.auvsim.diagnosis.result.Numbers;
import org.auvsim.diagnosis.result.Phrases;
import org.auvsim.diagnosis.result.Proposal;
import org.auvsim.diagnosis.result.QuantityGroup;
import org.auvsim.diagnosis.result.Ranked;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.plot.page.Block;
import org.auvsim.plot.page.Block.Table;
import org.auvsim.plot.page.Block.Text;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** What was found and tried, as tables. */
final class FindingTables {
    private static final int MOST_RANKED = 20;
    private static final int MOST_SENSORS = 3;

    /** So many causes at once can imitate one. */
    private static final int SEVERAL = 3;

    private static final String MAY_IMITATE =
            " But as many causes at once can imitate one that is not known: a run of another"
                    + " manoeuvre, held out, would tell that.";

    private static final String SHARE =
            "The share is what goes of the misfit beyond noise when this cause is added last.";

    private final Diagnosis of;
    private final Moments moments;

    FindingTables(Diagnosis of) {
        this.of = of;
        this.moments = new Moments(of.runs().stream().map(DiagnosedRun::run).toList());
    }

    List<Block> found() {
        List<Block> blocks = new ArrayList<>();
        if (!of.selected().isEmpty()) {
            blocks.add(table(of.selected(), "Values with their standard deviations. " + SHARE));
        }
        if (!of.isUntried()) {
            of.conclusion().discrepancy().map(this::discrepancy).ifPresent(blocks::add);
        }
        of.conclusion().approximation().map(this::approximation).ifPresent(blocks::add);
        of.conclusion().proposal().map(FindingTables::proposal).ifPresent(blocks::add);
        return blocks;
    }

    private Table approximation(Approximation near) {
        return table(
                near.causes(),
                "An approximation, no finding: the best causes that were tried bring the model much"
                        + " nearer to the runs, but leave more than noise. They stand for something"
                        + " that is not known. "
                        + SHARE
                        + " "
                        + Report.APPROXIMATE
                        + " has the model with them.");
    }

    private Table table(List<Finding> causes, String caption) {
        List<List<String>> rows = new ArrayList<>();
        for (Finding finding : causes) {
            String meaning = Phrases.of(finding);
            String share = Numbers.percent(finding.share());
            for (QuantityGroup group : QuantityGroup.of(finding)) {
                rows.add(
                        List.of(
                                finding.name(),
                                meaning,
                                group.name(),
                                plusMinus(moments.text(group)),
                                share));
                meaning = "";
                share = "";
            }
        }
        return new Table(
                List.of("cause", "meaning", "number", "value", "share of the misfit"),
                rows,
                caption);
    }

    private static String plusMinus(String text) {
        return text.replace("+-", "\u00b1");
    }

    private static String place(Vec3 at) {
        return "x %s, y %s, z %s m"
                .formatted(
                        Numbers.rounded(at.x(), 3),
                        Numbers.rounded(at.y(), 3),
                        Numbers.rounded(at.z(), 3));
    }

    private Table discrepancy(Discrepancy seen) {
        List<List<String>> rows = new ArrayList<>();
        rows.add(List.of("shows most in", seen.axis().within(seen.channel())));
        rows.add(List.of("largest at", moments.text(seen.time(), seen.run())));
        rows.add(List.of("the model is then at", place(seen.place())));
        seen.frequency()
                .ifPresent(hz -> rows.add(List.of("frequency", Numbers.rounded(hz) + " Hz")));
        rows.add(List.of("share that known causes take away", Numbers.percent(seen.share())));
        return new Table(
                List.of("what is known of the misfit", ""),
                rows,
                (of.isComplete() ? "No set of known causes" : "No set of causes tried so far")
                        + " leaves residuals that look like noise and predicts the"
                        + " held-out runs; the best ones are in the ranking below.");
    }

    private static Text proposal(Proposal proposal) {
        return new Text(
                "A proposal, not a named cause (%s): %s. With it the position error on held-out runs is %s m instead of %s m."
                        .formatted(
                                proposal.kind().replace('_', ' '),
                                proposal.text(),
                                Numbers.rounded(proposal.heldOut().after()),
                                Numbers.rounded(proposal.heldOut().before())));
    }

    List<Block> ranking() {
        if (of.evidence().ranked().isEmpty() || of.isUntried()) {
            return List.of();
        }
        List<Block> blocks = new ArrayList<>();
        blocks.add(new Text(Effort.words(of) + "."));
        if (of.evidence().isRanked()) {
            blocks.add(sets());
        }
        Effort.behind(of).map(Text::new).ifPresent(blocks::add);
        return blocks;
    }

    private Table sets() {
        List<Ranked> sets = of.evidence().ranked();
        double best = sets.getFirst().logEvidence();
        List<List<String>> rows = new ArrayList<>();
        for (Ranked ranked : sets.subList(0, Math.min(MOST_RANKED, sets.size()))) {
            rows.add(
                    List.of(
                            ranked.causes().isEmpty()
                                    ? "none: the model as believed"
                                    : ranked.name(),
                            numbers(ranked),
                            Numbers.rounded(ranked.logEvidence() - best, 3),
                            Numbers.probability(ranked.probability())));
        }
        int more = sets.size() - rows.size();
        return new Table(
                List.of("causes", "numbers", "log evidence", "probability"),
                rows,
                evidence() + (more > 0 ? " diagnosis.json has %d more.".formatted(more) : ""));
    }

    private String evidence() {
        return of.verdict() == Verdict.UNEXPLAINED
                ? "Natural logarithm of the evidence, less that of the set that has most."
                : "Natural logarithm of the evidence, less that of the set that was chosen, which"
                        + " stands first: below about -5 a set can be ruled out.";
    }

    /** Those of several causes under the name of each. */
    private String numbers(Ranked ranked) {
        List<String> causes = ranked.causes();
        return IntStream.range(0, causes.size())
                .mapToObj(
                        c ->
                                (causes.size() > 1 ? causes.get(c) + ": " : "")
                                        + numbers(ranked.quantities().get(c)))
                .collect(Collectors.joining("; "));
    }

    private String numbers(List<Quantity> quantities) {
        return QuantityGroup.of(quantities, List.of()).stream()
                .map(group -> group.name() + " = " + moments.text(group))
                .collect(Collectors.joining(", "));
    }

    List<Block> next() {
        Block run = of.evidence().nextExperiment().map(FindingTables::next).orElseGet(this::noNext);
        return Stream.concat(Stream.of(run), otherSensors().limit(MOST_SENSORS)).toList();
    }

    private Stream<Block> otherSensors() {
        return of.evidence().alternatives().stream()
                .filter(alternative -> !alternative.otherSensor().isEmpty())
                .map(
                        alternative ->
                                new Text(
                                        "Another sensor would tell %s apart in such runs: it differs in the %s."
                                                .formatted(
                                                        String.join(" + ", alternative.causes()),
                                                        alternative.otherSensor())));
    }

    private Block noNext() {
        return new Text(whyNoNext());
    }

    private String whyNoNext() {
        if (!of.isComplete()) {
            return "The search was stopped before it could tell what another run would show.";
        }
        if (of.verdict() == Verdict.UNEXPLAINED) {
            return "No run is proposed: there are no known causes left that it would have to tell"
                    + " apart.";
        }
        if (!of.evidence().alternatives().isEmpty()) {
            return "No run is proposed: none of those considered would tell these causes apart."
                    + " Other sensors or independent knowledge would be needed.";
        }
        String none =
                "No run is proposed: no other known causes explain these runs about as well, so"
                        + " there is nothing that another run would have to tell apart.";
        return of.selected().size() < SEVERAL ? none : none + MAY_IMITATE;
    }

    private static Block next(NextExperiment experiment) {
        String separates =
                experiment.separates().isEmpty()
                        ? ""
                        : " It would tell apart: %s."
                                .formatted(String.join(", ", experiment.separates()));
        return new Text(
                "%s (%s).%s The difference in log evidence to be expected is %s."
                        .formatted(
                                experiment.description().replaceFirst("[.]$", ""),
                                experiment.id(),
                                separates,
                                Numbers.rounded(experiment.evidence())));
    }

    List<Block> runs() {
        List<List<String>> rows =
                of.runs().stream()
                        .map(
                                run ->
                                        List.of(
                                                run.run().name(),
                                                role(of, run),
                                                String.valueOf(run.run().size()),
                                                Numbers.rounded(run.run().duration(), 3),
                                                channels(run)))
                        .toList();
        String noise =
                of.prediction().noise().entrySet().stream()
                        .map(
                                e ->
                                        "%s %s %s"
                                                .formatted(
                                                        e.getKey().words(),
                                                        Numbers.rounded(e.getValue()),
                                                        e.getKey().unit()))
                        .collect(Collectors.joining(", "));
        return List.of(
                new Table(
                        List.of("run", "role", "samples", "duration (s)", "measured"),
                        rows,
                        "Noise (standard deviation): %s. Seed: %d.".formatted(noise, of.seed())));
    }

    /** What a run was used for. */
    static String role(Diagnosis of, DiagnosedRun run) {
        String heldOut =
                of.prediction().usedHeldOut() ? "held out, but then searched with" : "held out";
        return run.isHeldOut() ? heldOut : "fitted";
    }

    private static String channels(DiagnosedRun of) {
        return Stream.of(Channel.values())
                .filter(of.run()::measures)
                .map(
                        channel ->
                                channel.words()
                                        + " "
                                        + IntStream.range(0, 3)
                                                .filter(axis -> of.run().measures(channel, axis))
                                                .mapToObj(axis -> "xyz".substring(axis, axis + 1))
                                                .collect(Collectors.joining())
                                        + ofBody(of.run(), channel))
                .collect(Collectors.joining(", "));
    }

    private static String ofBody(MeasuredRun run, Channel channel) {
        return run.frame(channel) == Frame.BODY ? " of the body" : "";
    }

    List<Block> notices() {
        return of.notices().stream().map(notice -> (Block) new Text(notice)).toList();
    }
}
