package org.auvsim.viz.window;

import org.auvsim.auvsml.Role;
import org.auvsim.viz.source.Steering;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.util.Locale;

import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** The line at the bottom: what the source says, the last words, the role, the frame rate. */
final class StatusBar {
    private final Desk desk;
    private final JLabel status = new JLabel(" ");
    private final JLabel last = new JLabel(" ");
    private final JLabel rate = new JLabel(" ");
    private final JPanel panel = new JPanel(new BorderLayout(16, 0));

    StatusBar(Desk desk) {
        this.desk = desk;
        status.setName("status");
        last.setName("last-words");
        last.setMinimumSize(new Dimension(0, 0));
        panel.setBorder(BorderFactory.createEmptyBorder(3, 8, 3, 8));
        panel.add(status, BorderLayout.WEST);
        panel.add(last, BorderLayout.CENTER);
        panel.add(rate, BorderLayout.EAST);
        desk.onWords(occurrence -> last.setText(occurrence.text()));
        desk.onRefresh(this::refresh);
    }

    JPanel component() {
        return panel;
    }

    private void refresh() {
        status.setText(desk.source().status());
        String role =
                desk.source()
                        .steering()
                        .map(Steering::role)
                        .map(Role::roleName)
                        .orElse("recording");
        rate.setText(
                String.format(
                        Locale.ROOT,
                        "%s%s%d objects   %s   %.0f frames/s",
                        desk.isDriving() ? "driving   " : "",
                        desk.options().followed().isPresent() ? "following   " : "",
                        desk.scene().objects().size(),
                        role,
                        desk.screen().frameRate()));
    }
}
