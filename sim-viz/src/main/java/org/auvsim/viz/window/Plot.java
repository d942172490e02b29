package org.auvsim.viz.window;

import org.knowm.xchart.XChartPanel;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.markers.SeriesMarkers;

import java.awt.BasicStroke;
import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import javax.swing.UIManager;

/**
 * A plot of one quantity or more over time. The title above it is the legend: each word has the
 * colour of its line, and nothing lies over the lines.
 */
final class Plot {
    /** The width is at least so long (s). */
    private static final double SHORTEST = 5;

    private static final DecimalFormatSymbols ROOT = DecimalFormatSymbols.getInstance(Locale.ROOT);

    private final Quantity[] quantities;
    private final XYChart chart;
    private final JLabel title;
    private final JPanel panel = new JPanel(new BorderLayout());

    /** Of quantities with one unit. */
    Plot(String unit, Quantity... quantities) {
        this.quantities = quantities.clone();
        title = new JLabel(title(unit, quantities), SwingConstants.CENTER);
        chart = new XYChartBuilder().width(260).height(140).build();
        for (Quantity quantity : quantities) {
            var series = chart.addSeries(quantity.word(), new double[] {0}, new double[] {0});
            series.setMarker(SeriesMarkers.NONE);
            series.setLineWidth(1.6f);
            series.setLineColor(quantity.colour());
            series.setLineStyle(new BasicStroke(1.6f));
        }
        XYStyler styler = chart.getStyler();
        styler.setLegendVisible(false);
        styler.setChartTitleVisible(false);
        styler.setChartPadding(4);
        styler.setPlotMargin(2);
        styler.setXAxisTickMarkSpacingHint(60);
        styler.setYAxisTickMarkSpacingHint(24);
        styler.setXAxisDecimalPattern("0.### s");
        if (isDeep()) {
            styler.setYAxisTickLabelsFormattingFunction(Plot::depth);
        } else {
            styler.setYAxisDecimalPattern("0.###");
        }
        XChartPanel<XYChart> lines = new XChartPanel<>(chart);
        // Its keys would take those of the window's menus.
        lines.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).clear();
        panel.add(title, BorderLayout.NORTH);
        panel.add(lines, BorderLayout.CENTER);
        panel.setMinimumSize(new Dimension(60, 60));
    }

    private static String title(String unit, Quantity... quantities) {
        return Stream.of(quantities)
                .map(
                        quantity ->
                                "<font color='#%06x'>%s</font>"
                                        .formatted(
                                                quantity.colour().getRGB() & 0xffffff,
                                                quantity.word()))
                .collect(Collectors.joining(", ", "<html>", " (" + unit + ")"));
    }

    JComponent component() {
        return panel;
    }

    /** What is deeper stands lower: the axis is the height, and tells the depth. */
    private boolean isDeep() {
        return quantities[0] == Quantity.DEPTH;
    }

    /**
     * Values after another one. A point without a value, farther from the others than they are from
     * one another, lets the chart put its ticks at round times: else it may put them at points.
     */
    private static double[] after(double first, double[] values) {
        double[] all = new double[values.length + 1];
        all[0] = first;
        System.arraycopy(values, 0, all, 1, values.length);
        return all;
    }

    private double[] upright(double[] values) {
        return isDeep() ? Arrays.stream(values).map(depth -> 0.0 - depth).toArray() : values;
    }

    private static String depth(double height) {
        return new DecimalFormat("0.###", ROOT).format(0.0 - height);
    }

    /** Takes the colours of the window. */
    void colour() {
        Color back = UIManager.getColor("Panel.background");
        Color front = UIManager.getColor("Label.foreground");
        Color faint = UIManager.getColor("Separator.foreground");
        Font font = UIManager.getFont("Label.font");
        XYStyler styler = chart.getStyler();
        styler.setChartBackgroundColor(back);
        styler.setPlotBackgroundColor(back);
        styler.setPlotBorderColor(faint);
        styler.setPlotGridLinesColor(faint);
        styler.setChartFontColor(front);
        styler.setAxisTickLabelsColor(front);
        styler.setXAxisTickLabelsColor(front);
        styler.setYAxisTickLabelsColor(front);
        styler.setAxisTickMarksColor(faint);
        styler.setAxisTickLabelsFont(font.deriveFont(10f));
        title.setFont(font.deriveFont(Font.BOLD, 12f));
    }

    void draw(History history) {
        double[] times = history.times();
        double end = times[times.length - 1];
        double start = Math.min(times[0], end - SHORTEST);
        double[] ticked = after(start - 2 * (end - start), times);
        for (Quantity quantity : quantities) {
            double[] line = after(Double.NaN, upright(history.line(quantity)));
            chart.updateXYSeries(quantity.word(), ticked, line, null);
        }
        double[] height = upright(history.height(quantities));
        XYStyler styler = chart.getStyler();
        styler.setXAxisMin(start);
        styler.setXAxisMax(end);
        styler.setYAxisMin(Math.min(height[0], height[1]));
        styler.setYAxisMax(Math.max(height[0], height[1]));
    }
}
