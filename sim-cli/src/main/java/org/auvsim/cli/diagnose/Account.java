package org.auvsim.cli.diagnose;

import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Effort;
import org.auvsim.diagnosis.result.Numbers;
import org.auvsim.diagnosis.result.Ranked;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** What a diagnosis comes to, in lines for people. */
public final class Account {
    private static final int MOST_RANKED = 5;
    private static final int WIDEST = 80;

    private Account() {}

    /**
     * The verdict, how much was tried for it, then the sets of causes that were tried, the best
     * first.
     */
    public static List<String> of(Diagnosis diagnosis) {
        List<String> lines = new ArrayList<>();
        lines.add(diagnosis.sentence());
        List<Ranked> ranked = diagnosis.evidence().ranked().stream().limit(MOST_RANKED).toList();
        if (!ranked.isEmpty() && !diagnosis.isUntried()) {
            lines.add("");
            lines.add(Effort.words(diagnosis) + ".");
            if (diagnosis.evidence().isRanked()) {
                lines.add("");
                addRanking(ranked, lines);
            }
            Effort.behind(diagnosis)
                    .ifPresent(
                            reasons -> {
                                lines.add("");
                                lines.add(reasons);
                            });
        }
        diagnosis
                .conclusion()
                .proposal()
                .ifPresent(
                        proposal -> {
                            lines.add("");
                            lines.add("A proposal, not a named cause: " + proposal.text());
                        });
        return lines;
    }

    private static void addRanking(List<Ranked> ranked, List<String> lines) {
        int width =
                Math.min(
                        WIDEST,
                        ranked.stream().mapToInt(each -> each.name().length()).max().orElse(0));
        String row = "%-" + Math.max(width, "causes".length()) + "s  %12s  %11s";
        lines.add(row.formatted("causes", "log evidence", "probability"));
        double best = ranked.getFirst().logEvidence();
        for (Ranked each : ranked) {
            double less = each.logEvidence() - best;
            lines.add(
                    String.format(
                            Locale.ROOT,
                            row,
                            each.name(),
                            String.format(Locale.ROOT, "%.1f", Math.abs(less) < 0.05 ? 0 : less),
                            Numbers.probability(each.probability())));
        }
    }
}
