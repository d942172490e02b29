package org.auvsim.plot;

import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.style.Styler;

import java.awt.Color;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.DoubleSummaryStatistics;
import java.util.List;

/** Charts that look alike, and pictures of them. */
public final class Charts {
    private static final int WIDTH = 900;
    private static final int HEIGHT = 420;

    /** Breadth by height of the area that a chart leaves for its curves. */
    private static final double ASPECT = 1.9;

    private Charts() {}

    /** A chart without curves; its axes are called {@code x} and {@code y}. */
    public static XYChart empty(String title, String x, String y) {
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

    /** Gives both axes the same scale and room for all that is drawn, which is finite. */
    public static void scaleEqually(
            XYChart chart, DoubleSummaryStatistics x, DoubleSummaryStatistics y) {
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

    /** The charts below one another as a PNG. */
    public static byte[] png(List<XYChart> charts) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        BitmapEncoder.saveBitmap(charts, charts.size(), 1, out, BitmapEncoder.BitmapFormat.PNG);
        return out.toByteArray();
    }
}
