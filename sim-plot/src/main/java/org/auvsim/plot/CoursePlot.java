package org.auvsim.plot;

import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.markers.SeriesMarkers;

import java.awt.Color;
import java.io.IOException;
import java.util.Arrays;
import java.util.Collection;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/** Courses as charts below one another: the paths from above, heights and speeds by time. */
public final class CoursePlot {
    private static final Color OF_MARKS = new Color(0xD1495B);

    private final List<Course> courses;
    private final List<Mark> marks;

    /** A point to look at, with what there is to see. */
    public record Mark(String label, Course.Sample at) {}

    /** A plot of courses, with points marked on them. */
    public CoursePlot(Collection<Course> courses, List<Mark> marks) {
        this.courses = List.copyOf(courses);
        this.marks = List.copyOf(marks);
    }

    /** The charts as a PNG. */
    public byte[] png() throws IOException {
        return Charts.png(
                List.of(
                        fromAbove(),
                        byTime("Height", "z (m)", s -> s.position().z()),
                        byTime("Speed", "speed (m/s)", Course.Sample::speed)));
    }

    private XYChart fromAbove() {
        XYChart chart = Charts.empty("The paths from above", "x (m)", "y (m)");
        draw(chart, s -> s.position().x(), s -> s.position().y());
        Charts.scaleEqually(
                chart, all(sample -> sample.position().x()), all(sample -> sample.position().y()));
        return chart;
    }

    private XYChart byTime(String title, String unit, ToDoubleFunction<Course.Sample> of) {
        XYChart chart = Charts.empty(title, "time (s)", unit);
        draw(chart, Course.Sample::time, of);
        return chart;
    }

    private void draw(
            XYChart chart, ToDoubleFunction<Course.Sample> x, ToDoubleFunction<Course.Sample> y) {
        for (Course course : courses) {
            add(chart, course.name(), course.values(x), course.values(y))
                    .forEach(line -> line.setMarker(SeriesMarkers.NONE));
        }
        for (Mark mark : marks) {
            double[] across = {x.applyAsDouble(mark.at())};
            double[] up = {y.applyAsDouble(mark.at())};
            add(chart, mark.label(), across, up).forEach(CoursePlot::highlight);
        }
    }

    /** A series of the points that are known; none if none are. */
    private static List<XYSeries> add(XYChart chart, String name, double[] x, double[] y) {
        int[] known =
                IntStream.range(0, x.length)
                        .filter(i -> Double.isFinite(x[i]) && Double.isFinite(y[i]))
                        .toArray();
        if (known.length == 0) {
            return List.of();
        }
        return List.of(
                chart.addSeries(
                        unique(name, chart),
                        Arrays.stream(known).mapToDouble(i -> x[i]).toArray(),
                        Arrays.stream(known).mapToDouble(i -> y[i]).toArray()));
    }

    /** One body may have left and another one of its name have come. */
    private static String unique(String name, XYChart chart) {
        Collection<XYSeries> drawn = chart.getSeriesCollection();
        return drawn.stream().anyMatch(line -> line.getName().equals(name))
                ? "%s (%d)".formatted(name, drawn.size() + 1)
                : name;
    }

    private static void highlight(XYSeries mark) {
        mark.setMarker(SeriesMarkers.CIRCLE);
        mark.setMarkerColor(OF_MARKS);
        mark.setXYSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.Scatter);
    }

    private DoubleSummaryStatistics all(ToDoubleFunction<Course.Sample> of) {
        DoubleSummaryStatistics all = new DoubleSummaryStatistics();
        courses.forEach(course -> Arrays.stream(course.values(of)).forEach(all));
        marks.forEach(mark -> all.accept(of.applyAsDouble(mark.at())));
        return all;
    }
}
