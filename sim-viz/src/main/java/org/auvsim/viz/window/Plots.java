package org.auvsim.viz.window;

import java.awt.CardLayout;
import java.awt.GridLayout;
import java.util.List;
import java.util.OptionalLong;

import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;

/** Plots of the selected object's last minute. */
final class Plots {
    /** One turn of so many redraws: a plot is dear. */
    private static final int EVERY = 3;

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
    private OptionalLong shown = OptionalLong.empty();
    private double drawn = Double.NaN;
    private int turn;

    Plots(Desk desk) {
        this.desk = desk;
        JLabel hint = new JLabel("Select an object to see its last minute", SwingConstants.CENTER);
        hint.setName("plots-hint");
        lines.setName("plots");
        plots.forEach(plot -> lines.add(plot.component()));
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

    private void refresh() {
        OptionalLong now =
                desk.selected().map(o -> OptionalLong.of(o.id())).orElse(OptionalLong.empty());
        boolean isOther = !now.equals(shown);
        turn = (turn + 1) % EVERY;
        if (!panel.isShowing() || (turn != 0 && !isOther)) {
            return;
        }
        double time = desk.scene().time();
        if (isOther) {
            shown = now;
            cards.show(panel, now.isPresent() ? LINES : HINT);
        }
        if (now.isPresent() && (isOther || time != drawn)) {
            drawn = time;
            draw(now.getAsLong(), time);
        }
    }

    private void draw(long id, double time) {
        desk.scene()
                .lookAt(id, actor -> History.of(actor, time))
                .ifPresent(history -> plots.forEach(plot -> plot.draw(history)));
        lines.repaint();
    }
}
