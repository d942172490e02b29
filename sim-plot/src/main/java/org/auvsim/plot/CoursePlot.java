package org.auvsim.plot;

import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler;
import org.knowm.xchart.style.markers.SeriesMarkers;

import java.awt.Color;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Collection;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/** Courses as charts below one another: the paths from above, heights and speeds by time. */
public final class CoursePlot {
    private static final int WIDTH = 900;
    private static final int HEIGHT = 420;

    /** Breadth by height of the area that a chart leaves for its curves. */
    private static final double ASPECT = 1.9;

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
        List<XYChart> charts =
                List.of(
                        fromAbove(),
                        byTime("Height", "z (m)", s -> s.position().z()),
                        byTime("Speed", "speed (m/s)", Course.Sample::speed));
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        BitmapEncoder.saveBitmap(charts, charts.size(), 1, out, BitmapEncoder.BitmapFormat.PNG);
        return out.toByteArray();
    }

    private XYChart fromAbove() {
        XYChart chart = chart("The paths from above", "x (m)", "y (m)");
        draw(chart, s -> s.position().x(), s -> s.position().y());
        scaleEqually(chart);
        return chart;
    }

    private XYChart byTime(String title, String unit, ToDoubleFunction<Course.Sample> of) {
        XYChart chart = chart(title, "time (s)", unit);
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

    private void scaleEqually(XYChart chart) {
        DoubleSummaryStatistics x = all(s -> s.position().x());
        DoubleSummaryStatistics y = all(s -> s.position().y());
        double broad = x.getMax() - x.getMin();
        double high = Math.max(Math.max(y.getMax() - y.getMin(), broad / ASPECT), 1) * 0.55;
        double middleX = (x.getMin() + x.getMax()) / 2;
        double middleY = (y.getMin() + y.getMax()) / 2;
        chart.getStyler()
                .setXAxisMin(middleX - ASPECT * high)
                .setXAxisMax(middleX + ASPECT * high)
                .setYAxisMin(middleY - high)
                .setYAxisMax(middleY + high);
    }

    private DoubleSummaryStatistics all(ToDoubleFunction<Course.Sample> of) {
        DoubleSummaryStatistics all = new DoubleSummaryStatistics();
        courses.forEach(course -> Arrays.stream(course.values(of)).forEach(all));
        marks.forEach(mark -> all.accept(of.applyAsDouble(mark.at())));
        return all;
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
                .setChartBackgroundColor(Color.WHITE);
        chart.getStyler().setXAxisDecimalPattern("0.##").setYAxisDecimalPattern("0.##");
        return chart;
    }
}
