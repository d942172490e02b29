package org.auvsim.diagnosis.report;

import org.auvsim.diagnosis.result.Alternative;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Identifiability.Confusion;
import org.auvsim.diagnosis.result.Identifiability.Smallest;
import org.auvsim.diagnosis.result.Numbers;
import org.auvsim.plot.page.Block;
import org.auvsim.plot.page.Block.Table;
import org.auvsim.plot.page.Block.Text;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** What the data can tell apart, and what it cannot. */
final class IdentifiabilityTables {
    private static final int MOST_PAIRS = 15;

    private final Diagnosis of;

    IdentifiabilityTables(Diagnosis of) {
        this.of = of;
    }

    List<Block> alternatives() {
        List<Alternative> alternatives = of.evidence().alternatives();
        if (alternatives.isEmpty()) {
            return List.of();
        }
        boolean isAnyDetermined =
                alternatives.stream().anyMatch(other -> !other.determined().isBlank());
        List<List<String>> rows = new ArrayList<>();
        for (Alternative alternative : alternatives) {
            List<String> row = new ArrayList<>();
            row.add(String.join(" + ", alternative.causes()));
            row.add(
                    alternative.isIndistinguishable()
                            ? "indistinguishable in such data"
                            : "nearly as good");
            if (isAnyDetermined) {
                row.add(alternative.determined());
            }
            rows.add(row);
        }
        return List.of(
                new Table(
                        isAnyDetermined
                                ? List.of("instead", "how close", "what it could be")
                                : List.of("instead", "how close"),
                        rows,
                        "Causes that explain the data about as well as " + found() + "."));
    }

    private String found() {
        return of.selected().stream().map(Finding::name).collect(Collectors.joining(" + "));
    }

    List<Block> pairs() {
        List<Confusion> pairs =
                of.evidence().identifiability().pairs().stream()
                        .sorted(Comparator.comparingDouble(Confusion::angle))
                        .limit(MOST_PAIRS)
                        .toList();
        if (pairs.isEmpty()) {
            return List.of();
        }
        List<List<String>> rows = new ArrayList<>();
        for (Confusion pair : pairs) {
            rows.add(
                    List.of(
                            pair.first(),
                            pair.firstNumber(),
                            pair.second(),
                            pair.secondNumber(),
                            Numbers.rounded(pair.angle()) + "\u00b0"));
        }
        int more = of.evidence().identifiability().pairs().size() - pairs.size();
        return List.of(
                new Table(
                        List.of("one cause", "its number", "another", "its number", "angle"),
                        rows,
                        "Angles between the traces that causes leave in this data: 90\u00b0 can be"
                                + " told apart best, 0\u00b0 not at all. Of a cause with several"
                                + " numbers, those together count that are most like the other"
                                + " cause, and the one that is most so is named."
                                + (more > 0
                                        ? " diagnosis.json has %d more.".formatted(more)
                                        : "")));
    }

    List<Block> unseen() {
        return Stream.concat(
                        words(
                                "Unless they are very strong, these leave no trace in this data",
                                of.evidence().identifiability().unseen()),
                        words(
                                "These change nothing that was measured: what they do is held, was"
                                        + " not measured, or does not come about in these runs",
                                of.evidence().identifiability().unobservable()))
                .toList();
    }

    private static Stream<Block> words(String what, List<String> causes) {
        return causes.isEmpty()
                ? Stream.empty()
                : Stream.of(new Text("%s: %s.".formatted(what, String.join(", ", causes))));
    }

    List<Block> smallest() {
        List<List<String>> rows = new ArrayList<>();
        for (Smallest each : of.evidence().identifiability().smallest()) {
            String unit = each.unit().equals("1") ? "" : " " + each.unit();
            rows.add(List.of(each.cause(), each.parameter(), Numbers.rounded(each.size()) + unit));
        }
        return rows.isEmpty()
                ? List.of()
                : List.of(
                        new Table(
                                List.of("cause", "number", "smallest change that would be found"),
                                rows,
                                "A cause that was not found is absent or smaller than this. 97"
                                        + " of 100 such measurements would reveal a change of this"
                                        + " size, taken alone beside what was found and to first"
                                        + " order. Causes tied to a place, a moment or a frequency"
                                        + " are not examined, as there are too many where they may"
                                        + " be. Other numbers that are not listed hardly show in"
                                        + " this data."));
    }
}
