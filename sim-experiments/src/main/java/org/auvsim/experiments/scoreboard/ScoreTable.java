package org.auvsim.experiments.scoreboard;

import org.auvsim.diagnosis.Method;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Outcomes and figures as lines of text. */
public final class ScoreTable {
    private ScoreTable() {}

    /** One case. */
    public static String line(Outcome o) {
        return String.format(
                Locale.ROOT,
                "%-5s %-9s %4.1f %% seed %-6d %-16s %5.1f s  hidden: %s  said%s: %s %s",
                o.isRight() ? "right" : "WRONG",
                o.kind(),
                100 * o.noise(),
                o.seed(),
                o.body(),
                o.seconds(),
                o.hidden().isEmpty() ? "nothing" : String.join(" + ", o.hidden()),
                o.method() == Method.GENETIC ? ", genetic" : "",
                o.said().verdict().name().toLowerCase(Locale.ROOT),
                String.join(" + ", o.said().causes()));
    }

    /** All figures, a line each. */
    public static List<String> lines(List<Scores> scores) {
        List<String> lines = new ArrayList<>();
        StringBuilder header = new StringBuilder("%-40s %-24s".formatted("", "target"));
        scores.forEach(at -> header.append(" %-26s".formatted(at.title())));
        lines.add(header.toString().stripTrailing());
        for (Figure figure : Figure.values()) {
            StringBuilder line =
                    new StringBuilder("%-40s %-24s".formatted(figure.title(), figure.target()));
            scores.forEach(at -> line.append(" %-26s".formatted(figure.of(at))));
            lines.add(line.toString().stripTrailing());
        }
        return lines;
    }
}
