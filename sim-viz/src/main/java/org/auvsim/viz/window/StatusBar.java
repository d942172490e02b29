package org.auvsim.viz.window;

import org.auvsim.auvsml.Role;
import org.auvsim.viz.scene.Counted;
import org.auvsim.viz.source.Steering;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.util.Locale;
import java.util.Optional;

import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.Timer;

/**
 * The line at the bottom: what the source says, for a while what has just been said, then the role
 * and the frame rate. Of a lost connection the banner alone tells.
 */
final class StatusBar {
    /** Words stand for so long (ms), a refusal until something succeeds at most. */
    private static final int WHILE = 10_000;

    private final Desk desk;
    private final JLabel status = new JLabel(" ");
    private final JLabel last = new JLabel(" ");
    private final JLabel rate = new JLabel(" ");
    private final JPanel panel = new JPanel(new BorderLayout(16, 0));
    private final Timer fade = new Timer(WHILE, e -> clear());
    private boolean isRefusal;

    StatusBar(Desk desk) {
        this.desk = desk;
        status.setName("status");
        last.setName("last-words");
        rate.setName("rate-words");
        fade.setRepeats(false);
        JPanel words = new JPanel(new BorderLayout(16, 0));
        words.setMinimumSize(new Dimension(0, 0));
        words.add(status, BorderLayout.WEST);
        words.add(last, BorderLayout.CENTER);
        panel.setBorder(BorderFactory.createEmptyBorder(3, 8, 3, 8));
        panel.add(words, BorderLayout.CENTER);
        panel.add(rate, BorderLayout.EAST);
        clear();
        desk.onWords(occurrence -> say(occurrence.text()));
        desk.onRefresh(this::refresh);
    }

    JPanel component() {
        return panel;
    }

    private void say(String sentence) {
        if (isInBanner(sentence)) {
            return;
        }
        last.setText(sentence);
        last.setToolTipText(sentence);
        isRefusal = desk.refusal().equals(Optional.of(sentence));
        fade.restart();
    }

    /** Whether that is what the banner tells already. */
    private boolean isInBanner(String sentence) {
        return desk.isLost() && desk.source().status().startsWith(sentence);
    }

    private void clear() {
        last.setText(" ");
        last.setToolTipText(null);
        isRefusal = false;
    }

    private void refresh() {
        if (desk.isLost()) {
            if (isInBanner(last.getText())) {
                clear();
            }
            status.setText(" ");
            status.setToolTipText(null);
            rate.setText(" ");
            return;
        }
        if (isRefusal && desk.refusal().isEmpty()) {
            clear();
        }
        status.setText(desk.source().status());
        status.setToolTipText(desk.source().status());
        rate.setText(
                String.format(
                        Locale.ROOT,
                        "%s%s%s   %s   %.0f frames/s",
                        desk.isDriving() && desk.selected().isPresent() ? "driving   " : "",
                        desk.options().followed().isPresent() ? "following   " : "",
                        Counted.of(desk.scene().objects().size(), "object"),
                        role(),
                        desk.screen().frameRate()));
    }

    private String role() {
        return desk.source().steering().map(Steering::role).map(Role::roleName).orElse("recording");
    }
}
