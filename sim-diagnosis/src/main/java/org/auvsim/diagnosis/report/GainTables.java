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
        if (of.horizons().size() < 2) {
            return List.of();
        }
        return List.of(
                new Chart(
                        "Position error by how far ahead is predicted",
                        "ahead (s)",
                        "error (m)",
                        List.of(
                                curve("as believed", Mark.LINE, Gain::before),
                                curve(after, Mark.LINE, Gain::after),
                                curve("noise", Mark.DASHED, Gain::noise)),
                        "From eight states along each held-out run, each fitted by the model: "
                                + after
                                + "."));
    }

    private Curve curve(String name, Mark mark, ToDoubleFunction<Gain> of) {
        List<Point> points = new ArrayList<>();
        for (HorizonGain horizon : this.of.horizons()) {
            points.add(new Point(horizon.ahead(), of.applyAsDouble(horizon.position())));
        }
        return new Curve(name, mark, points);
    }
}
