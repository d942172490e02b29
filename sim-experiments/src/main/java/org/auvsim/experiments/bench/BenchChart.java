package org.auvsim.experiments.bench;

import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.style.markers.SeriesMarkers;

import java.awt.Color;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** Measurements as charts over the number of bodies, both axes logarithmic. */
public final class BenchChart {
    private BenchChart() {}

    /** Writes a PNG of two charts, one below the other. */
    public static void write(Path file, List<Measurement> measurements) throws IOException {
        List<XYChart> charts =
                List.of(
                        chart("times real time", measurements, Measurement::timesRealTime),
                        chart("ns a body-step", measurements, Measurement::nanosPerBodyStep));
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        BitmapEncoder.saveBitmap(charts, charts.size(), 1, png, BitmapEncoder.BitmapFormat.PNG);
        Files.write(file, png.toByteArray());
    }

    private static XYChart chart(
            String what, List<Measurement> measurements, ToDoubleFunction<Measurement> of) {
        XYChart chart =
                new XYChartBuilder()
                        .width(900)
                        .height(420)
                        .title(what)
                        .xAxisTitle("bodies")
                        .yAxisTitle(what)
                        .build();
        chart.getStyler().setChartBackgroundColor(Color.WHITE).setLegendVisible(false);
        chart.getStyler().setXAxisLogarithmic(true).setYAxisLogarithmic(true);
        double[] bodies = measurements.stream().mapToDouble(Measurement::bodies).toArray();
        double[] values = measurements.stream().mapToDouble(of).toArray();
        chart.addSeries(what, bodies, values).setMarker(SeriesMarkers.CIRCLE);
        return chart;
    }
}
