package org.auvsim.diagnosis.report;

import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.result.HorizonGain;
import org.auvsim.diagnosis.result.Numbers;
import org.auvsim.diagnosis.result.Sentence;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.plot.page.Block;
import org.auvsim.plot.page.Block.Chart;
import org.auvsim.plot.page.Block.Table;
import org.auvsim.plot.page.Curve;
import org.auvsim.plot.page.Curve.Mark;
import org.auvsim.plot.page.Curve.Point;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** How much better held-out runs are predicted. */
final class GainTables {
    private final Diagnosis of;
    private final String after;

    /**
     * Tables of a diagnosis.
     *
     * @param after name of the model that is not the believed one
     */
    GainTables(Diagnosis of, String after) {
        this.of = of;
        this.after = after;
    }

    List<Block> byChannel() {
        if (of.heldOut().isEmpty()) {
            return List.of();
        }
        List<List<String>> rows = new ArrayList<>();
        of.heldOut().forEach((channel, gain) -> rows.add(row(channel, gain)));
        return List.of(
                new Table(
                        List.of("", "as believed", after, "noise", "unit"),
                        rows,
                        of.usedHeldOut()
                                ? "Root mean square errors; the held-out runs had to be used for"
                                        + " the search, so each run was left out in turn."
                                : "Root mean square errors of runs that nothing but their start was"
                                        + " fitted to; no model gets below the noise."));
    }

    private static List<String> row(Channel channel, Gain gain) {
        return List.of(
                Sentence.words(channel),
                Numbers.rounded(gain.before()),
                Numbers.rounded(gain.after()),
                Numbers.rounded(gain.noise()),
                Sentence.unit(channel));
    }

    List<Block> byHorizon() {
        List<Block> charts = new ArrayList<>();
        for (Channel channel : Channel.values()) {
            List<HorizonGain> horizons =
                    of.horizons().stream().filter(h -> h.errors().containsKey(channel)).toList();
            if (horizons.size() > 1) {
                charts.add(chart(channel, horizons));
            }
        }
        return charts;
    }

    private Chart chart(Channel channel, List<HorizonGain> horizons) {
        return new Chart(
                "Error of the %s by how far ahead is predicted".formatted(Sentence.words(channel)),
                "ahead (s)",
                "error (%s)".formatted(Sentence.unit(channel)),
                List.of(
                        curve("as believed", Mark.LINE, channel, horizons, Gain::before),
                        curve(after, Mark.LINE, channel, horizons, Gain::after),
                        curve("noise", Mark.DASHED, channel, horizons, Gain::noise)),
                "Predicted from eight states along each held-out run, each of them as the model "
                        + after
                        + " fits it; so few errors may lie below the noise.");
    }

    private static Curve curve(
            String name,
            Mark mark,
            Channel channel,
            List<HorizonGain> horizons,
            ToDoubleFunction<Gain> of) {
        List<Point> points =
                horizons.stream()
                        .map(h -> new Point(h.ahead(), of.applyAsDouble(h.errors().get(channel))))
                        .toList();
        return new Curve(name, mark, points);
    }
}
