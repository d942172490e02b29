package org.auvsim.viz.window;

import org.auvsim.viz.scene.Movement;
import org.knowm.xchart.XChartPanel;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.markers.SeriesMarkers;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.GridLayout;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;

import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.UIManager;

/** Plots of the selected object's last minute. */
final class Plots {
    private static final List<String> NAMES = List.of("x", "y", "z", "depth", "speed", "yaw");
    private static final int YAW = 5;
    private static final List<Color> COLOURS =
            List.of(
                    new Color(0xE5734F),
                    new Color(0x5BB974),
                    new Color(0x4F9BE5),
                    new Color(0x4F9BE5),
                    new Color(0xD9A441),
                    new Color(0xB57EDC));

    /** One turn of so many redraws: a chart is dear. */
    private static final int EVERY = 3;

    private final Desk desk;
    private final History history = new History();
    private final JPanel panel = new JPanel(new GridLayout(1, 0, 4, 0));
    private final List<XYChart> charts =
            List.of(
                    chart("x, y (m)", 0, 1),
                    chart("Depth (m)", 3),
                    chart("Speed (m/s)", 4),
                    chart("Yaw (\u00b0)", 5));
    private final List<int[]> shown =
            List.of(new int[] {0, 1}, new int[] {3}, new int[] {4}, new int[] {5});
    private OptionalLong of = OptionalLong.empty();
    private int turn;
    private double drawn;

    Plots(Desk desk) {
        this.desk = desk;
        panel.setName("plots");
        for (XYChart chart : charts) {
            XChartPanel<XYChart> one = new XChartPanel<>(chart);
            // Its keys would take those of the window's menus.
            one.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).clear();
            one.setMinimumSize(new Dimension(60, 60));
            panel.add(one);
        }
        colour();
        desk.onRefresh(this::refresh);
    }

    JPanel component() {
        return panel;
    }

    private static XYChart chart(String title, int... quantities) {
        XYChart chart = new XYChartBuilder().width(260).height(140).title(title).build();
        for (int q : quantities) {
            var series = chart.addSeries(NAMES.get(q), new double[] {0}, new double[] {0});
            series.setMarker(SeriesMarkers.NONE);
            series.setLineWidth(1.6f);
            series.setLineColor(COLOURS.get(q));
            series.setLineStyle(new BasicStroke(1.6f));
        }
        XYStyler styler = chart.getStyler();
        styler.setLegendVisible(quantities.length > 1);
        styler.setLegendPosition(XYStyler.LegendPosition.InsideNW);
        styler.setLegendPadding(2);
        styler.setLegendBorderColor(new Color(0, true));
        styler.setChartPadding(4);
        styler.setPlotMargin(2);
        styler.setXAxisTickMarkSpacingHint(50);
        styler.setYAxisTickMarkSpacingHint(24);
        styler.setXAxisDecimalPattern("0.#");
        styler.setYAxisDecimalPattern("0.##");
        return chart;
    }

    /** Takes the colours of the window. */
    void colour() {
        Color back = UIManager.getColor("Panel.background");
        Color front = UIManager.getColor("Label.foreground");
        Color faint = UIManager.getColor("Separator.foreground");
        Font font = UIManager.getFont("Label.font");
        for (XYChart chart : charts) {
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
            styler.setLegendBackgroundColor(new Color(0, true));
            styler.setChartTitleFont(font.deriveFont(Font.BOLD, 12f));
            styler.setAxisTickLabelsFont(font.deriveFont(10f));
            styler.setLegendFont(font.deriveFont(10f));
        }
        panel.repaint();
    }

    private void refresh() {
        OptionalLong now = desk.options().selected();
        if (!now.equals(of)) {
            of = now;
            history.clear();
        }
        Optional<Movement> motion =
                now.isPresent() ? desk.scene().motion(now.getAsLong()) : Optional.empty();
        motion.ifPresent(m -> history.add(desk.scene().time(), m));
        turn = (turn + 1) % EVERY;
        if (turn == 0 && panel.isShowing() && history.last() != drawn) {
            drawn = history.last();
            draw();
        }
    }

    /** Draws no line from 180 to -180 degrees. */
    private static void breakAtTurns(double... yaw) {
        for (int i = yaw.length - 1; i > 0; i--) {
            if (Math.abs(yaw[i] - yaw[i - 1]) > 180) {
                yaw[i] = Double.NaN;
            }
        }
    }

    private void draw() {
        double[] times = history.times();
        if (times.length < 2) {
            times = new double[] {0, 1};
        }
        for (int c = 0; c < charts.size(); c++) {
            for (int q : shown.get(c)) {
                double[] values = history.values(q);
                if (q == YAW) {
                    breakAtTurns(values);
                }
                charts.get(c)
                        .updateXYSeries(
                                NAMES.get(q),
                                times,
                                values.length < 2 ? new double[] {0, 0} : values,
                                null);
            }
        }
        panel.repaint();
    }
}
