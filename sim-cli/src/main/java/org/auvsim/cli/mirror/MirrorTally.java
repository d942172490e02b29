package org.auvsim.cli.mirror;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * How far two simulators were apart, and what became of the corrections.
 *
 * @param rows one for each object that both have
 * @param sent corrections
 * @param applied by the server
 * @param refused by it
 * @param refusal what it said the first time
 * @param skipped movements that it did not send since this side was slow
 */
public record MirrorTally(
        List<Row> rows,
        int sent,
        int applied,
        int refused,
        Optional<String> refusal,
        long skipped) {
    /**
     * An object.
     *
     * @param compared how often its two positions were compared
     * @param rms root of the mean square of their distance (m)
     * @param largest distance (m)
     * @param last distance (m) when they were last compared
     */
    public record Row(String name, int compared, double rms, double largest, double last) {}

    /** All of it in lines, for people. */
    public List<String> report() {
        List<String> lines = new ArrayList<>();
        int width = Math.max(6, rows.stream().mapToInt(r -> r.name().length()).max().orElse(0));
        lines.add(
                String.format(
                        Locale.ROOT,
                        "%-" + width + "s %10s %12s %12s %12s",
                        "object",
                        "compared",
                        "rms (m)",
                        "largest (m)",
                        "at end (m)"));
        for (Row row : rows) {
            lines.add(
                    String.format(
                            Locale.ROOT,
                            "%-" + width + "s %10d %12.6f %12.6f %12.6f",
                            row.name(),
                            row.compared(),
                            row.rms(),
                            row.largest(),
                            row.last()));
        }
        if (sent > 0) {
            lines.add(
                    String.format(
                            Locale.ROOT,
                            "corrections: %d sent, %d applied, %d refused",
                            sent,
                            applied,
                            refused));
        }
        refusal.ifPresent(text -> lines.add("first refusal: " + text));
        if (skipped > 0) {
            lines.add(
                    String.format(
                            Locale.ROOT, "warning: the simulator left out %d movements", skipped));
        }
        return lines;
    }
}
