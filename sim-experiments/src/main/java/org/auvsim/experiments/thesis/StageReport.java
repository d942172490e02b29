package org.auvsim.experiments.thesis;

import static java.nio.charset.StandardCharsets.UTF_8;

import de.siegmar.fastcsv.writer.CsvWriter;

import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.markers.SeriesMarkers;

import java.awt.Color;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** What the stages cost, as lines of text, CSV and charts. */
public final class StageReport {
    private StageReport() {}

    /** The line above the first row. */
    public static String header() {
        return "  bodies    restricter        octree        finder    wall time (s)";
    }

    /** One number of bodies. */
    public static String row(StageCost cost) {
        return String.format(
                Locale.ROOT,
                "%8d %13d %13d %13d %16.4g",
                cost.bodies(),
                cost.restricter(),
                cost.partitioner(),
                cost.finder(),
                cost.wallSeconds());
    }

    /** The fits that there are enough numbers of bodies for. */
    public static List<String> fits(List<StageCost> costs) {
        return fittable(costs).stream().map(trend -> trend.describe(costs)).toList();
    }

    private static List<Trend> fittable(List<StageCost> costs) {
        return Arrays.stream(Trend.values()).filter(trend -> trend.isFittable(costs)).toList();
    }

    /** Writes thesis.csv, and thesis.png if there is a fit to show, to a folder. */
    public static void write(Path folder, List<StageCost> costs) throws IOException {
        try (CsvWriter csv = CsvWriter.builder().build(folder.resolve("thesis.csv"), UTF_8)) {
            csv.writeRecord("bodies", "restricter", "octree", "finder", "wall_s");
            for (StageCost cost : costs) {
                csv.writeRecord(
                        Integer.toString(cost.bodies()),
                        Long.toString(cost.restricter()),
                        Long.toString(cost.partitioner()),
                        Long.toString(cost.finder()),
                        Double.toString(cost.wallSeconds()));
            }
        }
        List<XYChart> charts = fittable(costs).stream().map(trend -> chart(trend, costs)).toList();
        if (!charts.isEmpty()) {
            ByteArrayOutputStream png = new ByteArrayOutputStream();
            BitmapEncoder.saveBitmap(charts, charts.size(), 1, png, BitmapEncoder.BitmapFormat.PNG);
            Files.write(folder.resolve("thesis.png"), png.toByteArray());
        }
    }

    private static XYChart chart(Trend trend, List<StageCost> costs) {
        XYChart chart =
                new XYChartBuilder()
                        .width(900)
                        .height(420)
                        .title(trend.title())
                        .xAxisTitle("bodies")
                        .yAxisTitle(trend.unit())
                        .build();
        chart.getStyler().setChartBackgroundColor(Color.WHITE);
        double[] bodies = costs.stream().mapToDouble(StageCost::bodies).toArray();
        PolynomialFit fit = trend.fit(costs);
        String name = String.format(Locale.ROOT, "fit, R^2 = %.6f", fit.rSquared());
        double[] fitted = Arrays.stream(bodies).map(fit::at).toArray();
        chart.addSeries(name, bodies, fitted).setMarker(SeriesMarkers.NONE);
        chart.addSeries("measured", bodies, trend.values(costs))
                .setXYSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.Scatter);
        return chart;
    }
}
