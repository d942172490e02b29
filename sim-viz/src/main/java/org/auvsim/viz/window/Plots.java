package org.auvsim.viz.window;

import org.auvsim.viz.scene.SeenObject;

import java.awt.CardLayout;
import java.awt.GridLayout;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;

import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;

/** Plots of the selected object's last minute. */
final class Plots {
    /** One turn of so many redraws: a plot is dear. */
    private static final int EVERY = 3;

    /** A plot is at least so wide (pixels); those that have no room are left out. */
    private static final int WIDTH = 150;

    private static final String NOBODY = "Select an object to see its last minute";
    private static final String HINT = "hint";
    private static final String LINES = "lines";

    private final Desk desk;
    private final CardLayout cards = new CardLayout();
    private final JPanel panel = new JPanel(cards);
    private final JPanel lines = new JPanel(new GridLayout(1, 0, 4, 0));
    private final List<Plot> plots =
            List.of(
                    new Plot("m", Quantity.X, Quantity.Y),
                    new Plot("m", Quantity.DEPTH),
                    new Plot("m/s", Quantity.SPEED),
                    new Plot("\u00b0", Quantity.YAW));
    private final JLabel hint = new JLabel(NOBODY, SwingConstants.CENTER);
    private OptionalLong shown = OptionalLong.empty();
    private double drawn = Double.NaN;
    private int turn;

    Plots(Desk desk) {
        this.desk = desk;
        hint.setName("plots-hint");
        lines.setName("plots");
        panel.addComponentListener(
                new ComponentAdapter() {
                    @Override
                    public void componentResized(ComponentEvent e) {
                        arrange();
                    }
                });
        arrange();
        panel.add(hint, HINT);
        panel.add(lines, LINES);
        colour();
        desk.onRefresh(this::refresh);
    }

    JPanel component() {
        return panel;
    }

    /** Takes the colours of the window. */
    void colour() {
        plots.forEach(Plot::colour);
        panel.repaint();
    }

    /** As many plots as have room, one at least. */
    private void arrange() {
        int count = Math.clamp(panel.getWidth() / WIDTH, 1, plots.size());
        if (count != lines.getComponentCount()) {
            lines.removeAll();
            plots.subList(0, count).forEach(plot -> lines.add(plot.component()));
            lines.revalidate();
        }
    }

    private void refresh() {
        Optional<SeenObject> object = desk.selected();
        OptionalLong now = object.map(o -> OptionalLong.of(o.id())).orElse(OptionalLong.empty());
        boolean isOther = !now.equals(shown);
        turn = (turn + 1) % EVERY;
        if (!panel.isShowing() || (turn != 0 && !isOther)) {
            return;
        }
        double time = desk.scene().time();
        if (isOther || time != drawn) {
            shown = now;
            drawn = time;
            show(object, time);
        }
    }

    private void show(Optional<SeenObject> object, double time) {
        Optional<History> history =
                object.filter(o -> !o.isFixed())
                        .flatMap(o -> desk.scene().lookAt(o.id(), a -> History.of(a, time)))
                        .filter(h -> h.times().length > 1);
        if (history.isPresent()) {
            plots.forEach(plot -> plot.draw(history.get()));
            lines.repaint();
        } else {
            hint.setText(object.map(Plots::why).orElse(NOBODY));
        }
        cards.show(panel, history.isPresent() ? LINES : HINT);
    }

    /** Why there is nothing to plot of an object. */
    private static String why(SeenObject object) {
        return object.name() + (object.isFixed() ? " is fixed: it does not move" : ": no data yet");
    }
}
