package org.auvsim.cli.plot;

import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.auvsim.core.world.WorldListener;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.style.Styler;
import org.knowm.xchart.style.markers.SeriesMarkers;

import java.awt.Color;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Collection;
import java.util.DoubleSummaryStatistics;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/**
 * Where the objects of a world go, from the time on at which it is made: paths, heights, speeds.
 */
public final class TrajectoryPlot implements WorldListener {
    private static final int MOST_OBJECTS = 10;
    private static final int WIDTH = 900;
    private static final int HEIGHT = 420;

    /** Breadth by height of the area that a chart leaves for its curves. */
    private static final double ASPECT = 1.9;

    private final World world;
    private final Map<Long, Course> courses = new LinkedHashMap<>();

    /** Watches what moves in a world; of many objects the first ten. */
    public TrajectoryPlot(World world) {
        this.world = world;
        look();
    }

    @Override
    public void happened(WorldEvent event) {
        if (event instanceof WorldEvent.StepAdvanced) {
            look();
        }
    }

    private void look() {
        for (WorldObject object : world.objects()) {
            if (!object.isFixed()
                    && (courses.size() < MOST_OBJECTS || courses.containsKey(object.id()))) {
                courses.computeIfAbsent(object.id(), _ -> new Course(object.name()))
                        .add(
                                new Course.Sample(
                                        world.time(), object.position(), object.velocity().norm()));
            }
        }
    }

    /** The path from above, height and speed by time, below one another. */
    public byte[] png() throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        List<XYChart> charts =
                List.of(
                        fromAbove(),
                        byTime("Height", "z (m)", s -> s.position().z()),
                        byTime("Speed", "speed (m/s)", Course.Sample::speed));
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
        for (Course course : courses.values()) {
            chart.addSeries(course.name(), course.values(x), course.values(y))
                    .setMarker(SeriesMarkers.NONE);
        }
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
        Collection<Course> drawn = courses.values();
        drawn.forEach(course -> Arrays.stream(course.values(of)).forEach(all));
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
