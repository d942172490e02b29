package org.auvsim.cli.demo;

import org.auvsim.core.math.Vec3;
import org.auvsim.plot.Charts;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.markers.SeriesMarkers;

import java.awt.Color;
import java.io.IOException;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;

/** The picture: the true path and the simulated ones, from above, along y, and how far apart. */
final class DemoPlot {
    private static final Color TRUTH = new Color(0x202020);
    private static final Color[] SIMULATED = {
        new Color(0xD1495B), new Color(0x00798C), new Color(0xEDAE49)
    };

    /** What lies below another one is broader, so that it can still be seen. */
    private static final float[] BREADTH = {1.6f, 3.6f, 1.4f};

    private DemoPlot() {}

    /**
     * The charts below one another, as a PNG.
     *
     * @param all of which the first, as many as there are colors, are shown side by side
     * @param learning whose error is shown by itself
     */
    static byte[] png(List<Track> all, Track learning) throws IOException {
        List<Track> tracks = all.subList(0, Math.min(SIMULATED.length, all.size()));
        return Charts.png(
                List.of(fromAbove(tracks), alongY(tracks), error(tracks), learning(learning)));
    }

    private static XYChart fromAbove(List<Track> tracks) {
        XYChart chart = Charts.empty("The paths from above", "x (m)", "y (m)");
        addTruth(chart, tracks.getFirst(), s -> s.truth().x(), s -> s.truth().y());
        for (int i = 0; i < tracks.size(); i++) {
            add(chart, tracks.get(i), i, s -> s.simulated().x(), s -> s.simulated().y());
        }
        Charts.scaleEqually(chart, all(tracks, Vec3::x), all(tracks, Vec3::y));
        return chart;
    }

    private static DoubleSummaryStatistics all(
            List<Track> tracks, ToDoubleFunction<Vec3> coordinate) {
        return tracks.stream()
                .flatMap(track -> track.samples().stream())
                .flatMap(sample -> Stream.of(sample.truth(), sample.simulated()))
                .mapToDouble(coordinate)
                .summaryStatistics();
    }

    private static XYChart alongY(List<Track> tracks) {
        XYChart chart = Charts.empty("Position along the y-axis", "time (s)", "y (m)");
        addTruth(chart, tracks.getFirst(), Track.Sample::time, s -> s.truth().y());
        for (int i = 0; i < tracks.size(); i++) {
            add(chart, tracks.get(i), i, Track.Sample::time, s -> s.simulated().y());
        }
        return chart;
    }

    private static XYChart error(List<Track> tracks) {
        XYChart chart =
                Charts.empty(
                        "Distance of the simulated from the true robot", "time (s)", "error (m)");
        for (int i = 0; i < tracks.size(); i++) {
            add(chart, tracks.get(i), i, Track.Sample::time, Track.Sample::error);
        }
        return chart;
    }

    private static XYChart learning(Track track) {
        XYChart chart =
                Charts.empty(
                        "Distance of the projected from the true robot while the server learns",
                        "time (s)",
                        "error (m)");
        Track shown = track.uncorrected();
        double[] times = values(shown, Track.Sample::time);
        style(
                chart.addSeries(track.name(), times, values(shown, Track.Sample::error)),
                SIMULATED[1],
                BREADTH[0]);
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
