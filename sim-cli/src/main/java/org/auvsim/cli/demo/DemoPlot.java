package org.auvsim.cli.demo;

import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler;
import org.knowm.xchart.style.markers.SeriesMarkers;

import java.awt.Color;
import java.awt.Font;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** The picture: the true path and the simulated ones, from above, along y, and how far apart. */
final class DemoPlot {
    private static final Color TRUTH = new Color(0x202020);
    private static final Color[] SIMULATED = {
        new Color(0xD1495B), new Color(0x00798C), new Color(0xEDAE49)
    };

    /** What lies below another one is broader, so that it can still be seen. */
    private static final float[] BREADTH = {1.6f, 3.6f, 1.4f};

    private static final int WIDTH = 900;
    private static final int HEIGHT = 420;

    private DemoPlot() {}

    /** The three charts below one another, as a PNG. */
    static byte[] png(List<Track> tracks) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        List<XYChart> charts = List.of(fromAbove(tracks), alongY(tracks), error(tracks));
        BitmapEncoder.saveBitmap(charts, charts.size(), 1, out, BitmapEncoder.BitmapFormat.PNG);
        return out.toByteArray();
    }

    private static XYChart fromAbove(List<Track> tracks) {
        XYChart chart = chart("The paths from above", "x (m)", "y (m)");
        addTruth(chart, tracks.getFirst(), s -> s.truth().x(), s -> s.truth().y());
        for (int i = 0; i < tracks.size(); i++) {
            add(chart, tracks.get(i), i, s -> s.simulated().x(), s -> s.simulated().y());
        }
        scaleEqually(chart, tracks);
        return chart;
    }

    /** Gives both axes the same scale: the area for the plot is about twice as wide as high. */
    private static void scaleEqually(XYChart chart, List<Track> tracks) {
        DoubleSummaryStatistics x = new DoubleSummaryStatistics();
        DoubleSummaryStatistics y = new DoubleSummaryStatistics();
        for (Track track : tracks) {
            for (Track.Sample sample : track.samples()) {
                x.accept(sample.truth().x());
                x.accept(sample.simulated().x());
                y.accept(sample.truth().y());
                y.accept(sample.simulated().y());
            }
        }
        double height = 1.1 * Math.max(y.getMax() - y.getMin(), (x.getMax() - x.getMin()) / 2);
        double middleX = (x.getMin() + x.getMax()) / 2;
        double middleY = (y.getMin() + y.getMax()) / 2;
        chart.getStyler()
                .setXAxisMin(middleX - height)
                .setXAxisMax(middleX + height)
                .setYAxisMin(middleY - height / 2)
                .setYAxisMax(middleY + height / 2);
    }

    private static XYChart alongY(List<Track> tracks) {
        XYChart chart = chart("Position along the y-axis", "time (s)", "y (m)");
        addTruth(chart, tracks.getFirst(), Track.Sample::time, s -> s.truth().y());
        for (int i = 0; i < tracks.size(); i++) {
            add(chart, tracks.get(i), i, Track.Sample::time, s -> s.simulated().y());
        }
        return chart;
    }

    private static XYChart error(List<Track> tracks) {
        XYChart chart =
                chart("Distance of the simulated from the true robot", "time (s)", "error (m)");
        for (int i = 0; i < tracks.size(); i++) {
            add(chart, tracks.get(i), i, Track.Sample::time, Track.Sample::error);
        }
        return chart;
    }

    private static XYChart chart(String title, String x, String y) {
        XYChart chart =
                new XYChartBuilder()
                        .width(WIDTH)
                        .height(HEIGHT)
                        .title(title)
                        .xAxisTitle(x)
                        .yAxisTitle(y)
                        .build();
        chart.getStyler()
                .setLegendPosition(Styler.LegendPosition.OutsideE)
                .setChartBackgroundColor(Color.WHITE)
                .setChartTitleFont(new Font(Font.SANS_SERIF, Font.BOLD, 15));
        chart.getStyler().setXAxisDecimalPattern("0.##").setYAxisDecimalPattern("0.##");
        return chart;
    }

    private static void addTruth(
            XYChart chart,
            Track track,
            ToDoubleFunction<Track.Sample> x,
            ToDoubleFunction<Track.Sample> y) {
        style(chart.addSeries("true path", values(track, x), values(track, y)), TRUTH, 5f);
    }

    private static void add(
            XYChart chart,
            Track track,
            int index,
            ToDoubleFunction<Track.Sample> x,
            ToDoubleFunction<Track.Sample> y) {
        style(
                chart.addSeries(track.name(), values(track, x), values(track, y)),
                SIMULATED[index],
                BREADTH[index]);
    }

    private static void style(XYSeries series, Color color, float width) {
        series.setMarker(SeriesMarkers.NONE);
        series.setLineColor(color);
        series.setLineWidth(width);
    }

    private static double[] values(Track track, ToDoubleFunction<Track.Sample> of) {
        return track.samples().stream().mapToDouble(of).toArray();
    }
}
