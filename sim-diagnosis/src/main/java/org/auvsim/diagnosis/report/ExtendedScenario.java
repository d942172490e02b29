package org.auvsim.diagnosis.report;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.mapping.ContextClasses;
import org.auvsim.diagnosis.result.Approximation;
import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Moments;
import org.auvsim.diagnosis.result.Phrases;
import org.auvsim.diagnosis.result.QuantityGroup;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** The model with what was found, as a scenario that says why. */
final class ExtendedScenario {
    private ExtendedScenario() {}

    static String text(Diagnosis diagnosis) {
        return text(lines(diagnosis), diagnosis.extended());
    }

    /** The model that explains nothing but is nearer. */
    static String text(Diagnosis diagnosis, Approximation nearer) {
        List<String> lines = new ArrayList<>(heading(diagnosis));
        lines.add(
                "An approximation, no finding: what is below stands for something that is not"
                        + " known.");
        Moments moments = moments(diagnosis);
        nearer.causes().stream().map(cause -> line(cause, moments)).forEach(lines::add);
        return text(lines, nearer.scenario());
    }

    private static String text(List<String> lines, Scenario scenario) {
        return comment(lines) + AuvsmlMapper.load(ContextClasses.loader()).encode(scenario);
    }

    private static List<String> heading(Diagnosis diagnosis) {
        return List.of(
                "A diagnosis of '%s' (seed %d).".formatted(diagnosis.body(), diagnosis.seed()),
                diagnosis.sentence() + ".");
    }

    private static List<String> lines(Diagnosis diagnosis) {
        List<String> lines = new ArrayList<>(heading(diagnosis));
        Moments moments = moments(diagnosis);
        List<Finding> added = diagnosis.selected().stream().filter(Finding::isOfModel).toList();
        lines.add(
                added.isEmpty()
                        ? "Nothing was added: this is the model as it was believed."
                        : "What was added to the model as it was believed:");
        added.stream().map(cause -> line(cause, moments)).forEach(lines::add);
        List<Finding> others = diagnosis.selected().stream().filter(f -> !f.isOfModel()).toList();
        if (!others.isEmpty()) {
            lines.add("What was found beside that, which no scenario has:");
            others.stream().map(cause -> line(cause, moments)).forEach(lines::add);
        }
        return lines;
    }

    private static Moments moments(Diagnosis of) {
        return new Moments(of.runs().stream().map(DiagnosedRun::run).toList());
    }

    private static String line(Finding finding, Moments moments) {
        String numbers =
                QuantityGroup.of(finding).stream()
                        .map(group -> group.name() + " = " + moments.text(group))
                        .collect(Collectors.joining(", "));
        return "- %s: %s; %s"
                .formatted(finding.name(), numbers, Phrases.inside(Phrases.of(finding)));
    }

    /** Two hyphens end a comment. */
    private static String comment(List<String> lines) {
        return lines.stream()
                .map(line -> line.replaceAll("-(?=-)", "- ").replace("\n", " "))
                .collect(Collectors.joining("\n  ", "<!--\n  ", "\n-->\n"));
    }
}
