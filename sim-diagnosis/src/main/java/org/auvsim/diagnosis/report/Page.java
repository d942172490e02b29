package org.auvsim.diagnosis.report;

import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.plot.page.Block;
import org.auvsim.plot.page.Report;
import org.auvsim.plot.page.Report.Section;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** A diagnosis as a page for people: what was found first, what it rests on below. */
final class Page {
    private final Diagnosis of;
    private final FindingTables findings;
    private final List<String> names;

    private Page(Diagnosis of) {
        this.of = of;
        this.findings = new FindingTables(of);
        this.names = names(of);
    }

    /** Of the models that runs are compared with: one, if nothing changes. */
    private static List<String> names(Diagnosis of) {
        boolean isChanged = of.runs().stream().anyMatch(run -> !run.before().equals(run.after()));
        return isChanged ? List.of("as believed", after(of)) : List.of("simulated");
    }

    private static String after(Diagnosis of) {
        return of.verdict() == Verdict.UNEXPLAINED
                ? "with the best that was tried"
                : "with what was found";
    }

    static Report of(Diagnosis diagnosis) {
        Page page = new Page(diagnosis);
        return new Report(
                "%s: %s".formatted(diagnosis.body(), page.verdict()),
                page.summary(),
                Stream.of(
                                page.section("What was found", page.findings.found()),
                                page.section("Notices", page.findings.notices()),
                                page.section("Gain on held-out runs", page.gain()),
                                page.paths(),
                                page.section("Causes that were tried", page.findings.ranking()),
                                page.section("What this data can tell apart", page.apart()),
                                page.missed(),
                                page.section("What to measure next", page.findings.next()),
                                page.section("The runs", page.findings.runs()),
                                page.runs())
                        .flatMap(List::stream)
                        .toList());
    }

    private String verdict() {
        if (of.isUntried()) {
            return reached() + ", stopped early";
        }
        return of.isComplete() ? reached() : reached() + " so far, stopped early";
    }

    private String reached() {
        return switch (of.verdict()) {
            case EXPLAINED -> "explained";
            case NONE -> "nothing missing";
            case UNEXPLAINED -> "unexplained";
            case UNDECIDED -> "undecided";
        };
    }

    private String summary() {
        return of.sentence().replace("+-", "\u00b1").replace("->", "\u2192") + ".";
    }

    private List<Section> section(String heading, List<Block> blocks) {
        return blocks.isEmpty() ? List.of() : List.of(new Section(heading, blocks));
    }

    private List<Block> gain() {
        GainTables tables = new GainTables(of.prediction(), names);
        return Stream.of(tables.byChannel(), tables.byHorizon()).flatMap(List::stream).toList();
    }

    private List<Block> apart() {
        IdentifiabilityTables tables = new IdentifiabilityTables(of);
        return Stream.of(tables.alternatives(), tables.pairs(), tables.unseen())
                .flatMap(List::stream)
                .toList();
    }

    /** What a verdict that nothing is missing is worth; behind a click where something is. */
    private List<Section> missed() {
        List<Block> smallest = new IdentifiabilityTables(of).smallest();
        boolean isKnown = of.verdict() == Verdict.EXPLAINED || of.verdict() == Verdict.NONE;
        return !isKnown || smallest.isEmpty()
                ? List.of()
                : List.of(
                        new Section(
                                "What could have been missed",
                                of.verdict() == Verdict.EXPLAINED,
                                smallest));
    }

    private RunCharts charts(DiagnosedRun run) {
        return new RunCharts(run, of.prediction().noise(), names);
    }

    /** Of one run that people see at once: a held-out one, if there is one. */
    private List<Section> paths() {
        return Stream.concat(of.runs().stream().filter(DiagnosedRun::isHeldOut), of.runs().stream())
                .findFirst()
                .map(
                        run ->
                                List.of(
                                        new Section(
                                                "Measured and simulated: " + title(run),
                                                charts(run).paths())))
                .orElse(List.of());
    }

    private List<Section> runs() {
        List<Section> sections = new ArrayList<>();
        for (DiagnosedRun run : of.runs()) {
            sections.add(new Section("In detail: " + title(run), true, charts(run).all()));
        }
        return sections;
    }

    private String title(DiagnosedRun run) {
        return "%s (%s)".formatted(run.run().name(), FindingTables.role(of, run));
    }
}
