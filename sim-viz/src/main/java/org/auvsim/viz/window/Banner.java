package org.auvsim.viz.window;

import java.awt.Color;
import java.awt.Font;

import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.SwingConstants;

/** Words across the window while there is no connection. */
final class Banner {
    private static final Color AMBER = new Color(0xF2B84B);
    private static final Color INK = new Color(0x2B2100);

    private final Desk desk;
    private final JLabel label = new JLabel(" ", SwingConstants.CENTER);

    Banner(Desk desk) {
        this.desk = desk;
        label.setName("banner");
        label.setOpaque(true);
        label.setBackground(AMBER);
        label.setForeground(INK);
        label.setFont(label.getFont().deriveFont(Font.BOLD));
        label.setBorder(BorderFactory.createEmptyBorder(6, 12, 6, 12));
        label.setVisible(false);
        desk.onRefresh(this::refresh);
    }

    JLabel component() {
        return label;
    }

    private void refresh() {
        boolean isLost = desk.isLost();
        if (isLost) {
            label.setText(desk.source().status());
        }
        if (label.isVisible() != isLost) {
            label.setVisible(isLost);
        }
    }
}
