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
        styler.setXAxisTickMarkSpacingHint(50);
        styler.setYAxisTickMarkSpacingHint(24);
        styler.setXAxisTickLabelsFormattingFunction(Plot::seconds);
        styler.setYAxisDecimalPattern("0.###");
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

    private static String seconds(double time) {
        return String.format(Locale.ROOT, time == Math.rint(time) ? "%.0f s" : "%.1f s", time);
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
        for (Quantity quantity : quantities) {
            chart.updateXYSeries(quantity.word(), times, history.line(quantity), null);
        }
        double end = times[times.length - 1];
        double[] height = history.height(quantities);
        XYStyler styler = chart.getStyler();
        styler.setXAxisMin(Math.min(times[0], end - SHORTEST));
        styler.setXAxisMax(end);
        styler.setYAxisMin(height[0]);
        styler.setYAxisMax(height[1]);
    }
}
