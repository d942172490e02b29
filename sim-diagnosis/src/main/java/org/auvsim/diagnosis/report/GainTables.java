package org.auvsim.diagnosis.report;

import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.result.HorizonGain;
import org.auvsim.diagnosis.result.Numbers;
import org.auvsim.diagnosis.result.Prediction;
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
    private final Prediction of;
    private final List<String> models;

    /**
     * Tables of predictions.
     *
     * @param models names of the believed model and of the one that was found, if it is another
     */
    GainTables(Prediction of, List<String> models) {
        this.of = of;
        this.models = models;
    }

    List<Block> byChannel() {
        if (of.gains().isEmpty()) {
            return List.of();
        }
        List<String> heading = new ArrayList<>(models);
        heading.addFirst("");
        heading.addAll(List.of("noise", "unit"));
        List<List<String>> rows = new ArrayList<>();
        of.gains().forEach((channel, gain) -> rows.add(row(channel, gain)));
        return List.of(
                new Table(
                        heading,
                        rows,
                        of.usedHeldOut()
                                ? "Root mean square errors; the held-out runs had to be used for"
                                        + " the search, so each run was left out in turn."
                                : "Root mean square errors from the same start, which is all that"
                                      + " was fitted to these runs. The noise is estimated: a true"
                                      + " model's error is about as large."));
    }

    private List<String> row(Channel channel, Gain gain) {
        List<String> row = new ArrayList<>();
        row.add(channel.words());
        errors(gain).forEach(error -> row.add(Numbers.rounded(error)));
        row.add(Numbers.rounded(gain.noise()));
        row.add(channel.unit());
        return row;
    }

    /** One for each model. */
    private List<Double> errors(Gain gain) {
        return List.of(gain.before(), gain.after()).subList(0, models.size());
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
        List<Curve> curves = new ArrayList<>();
        for (int k = 0; k < models.size(); k++) {
            int model = k;
            curves.add(
                    curve(models.get(k), Mark.LINE, channel, horizons, g -> errors(g).get(model)));
        }
        curves.add(curve("noise", Mark.DASHED, channel, horizons, Gain::noise));
        boolean isLost =
                curves.stream()
                        .flatMap(curve -> curve.points().stream())
                        .anyMatch(point -> Double.isInfinite(point.y()));
        return Chart.logarithmic(
                "Error of the %s by how far ahead is predicted".formatted(channel.words()),
                "ahead (s)",
                "error (%s)".formatted(channel.unit()),
                curves,
                "Predicted from eight states along each held-out run, each estimated by the model%s; with so few predictions an error may fall below the noise.%s"
                        .formatted(
                                models.size() > 1 ? " " + models.getLast() : "",
                                isLost ? " Where a model gets lost it has no point." : ""));
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
