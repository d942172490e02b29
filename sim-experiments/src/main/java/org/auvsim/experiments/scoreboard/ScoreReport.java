package org.auvsim.experiments.scoreboard;

import org.auvsim.diagnosis.Method;
import org.auvsim.plot.page.Block.Table;
import org.auvsim.plot.page.Block.Text;
import org.auvsim.plot.page.Report;
import org.auvsim.plot.page.Report.Section;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The scoreboard as a page. */
final class ScoreReport {
    private ScoreReport() {}

    static Report of(Plan plan, List<Scores> scores, List<Outcome> outcomes) {
        List<Outcome> own = outcomes.stream().filter(o -> o.method() == Method.SHOOTING).toList();
        long right = own.stream().filter(Outcome::isRight).count();
        return new Report(
                "Diagnosis: how well it finds what is hidden",
                plan.shortfall(outcomes.size()).map(sentence -> sentence + " ").orElse("")
                        + "%d of %d cases are right.".formatted(right, own.size()),
                List.of(figures(plan, scores), mistakes(outcomes)));
    }

    private static Section figures(Plan plan, List<Scores> scores) {
        List<String> header = new ArrayList<>(List.of("", "target"));
        scores.forEach(at -> header.add(at.title()));
        List<List<String>> rows = new ArrayList<>();
        for (Figure figure : Figure.values()) {
            List<String> row = new ArrayList<>(List.of(figure.title(), figure.target()));
            scores.forEach(at -> row.add(figure.of(at)));
            rows.add(row);
        }
        return Section.of(
                "Figures",
                new Text(
                        "Seeds from %d on, %d cases at each noise, the first %d also by models that compete (genetic)."
                                .formatted(plan.seed(), plan.cases(), plan.genetic())),
                new Table(header, rows, "In brackets: counts, and 95 % intervals of Wilson."));
    }

    private static Section mistakes(List<Outcome> outcomes) {
        List<List<String>> rows =
                outcomes.stream()
                        .filter(o -> !o.isRight())
                        .map(
                                o ->
                                        List.of(
                                                o.body(),
                                                o.hidden().isEmpty()
                                                        ? "nothing"
                                                        : String.join(" + ", o.hidden()),
                                                o.said().verdict().name().toLowerCase(Locale.ROOT),
                                                String.join(" + ", o.said().causes()),
                                                o.repeat()))
                        .toList();
        return Section.of(
                "Mistakes",
                new Table(
                        List.of("body", "hidden", "said", "named", "to repeat"),
                        rows,
                        "Each can be made again."));
    }
}
