package org.auvsim.viz.window;

import org.auvsim.viz.source.Playback;

import java.awt.BorderLayout;
import java.awt.FlowLayout;
import java.util.List;
import java.util.Locale;

import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JPanel;
import javax.swing.JSlider;

/** The time line of a recording. */
final class PlaybackBar {
    private static final int PARTS = 10_000;
    private static final Double[] RATES = {0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 50.0};

    private final Playback playback;
    private final JPanel panel = new JPanel(new BorderLayout(8, 0));
    private final JSlider slider = new JSlider(0, PARTS, 0);
    private final JButton play;
    private final JLabel time = new JLabel();
    private boolean isUpdating;

    PlaybackBar(Desk desk, Playback playback) {
        this.playback = playback;
        JButton back = button("step-back", Signs.STEP_BACK, "One step back", () -> step(desk, -1));
        play = button("play", Signs.PLAY, "Play or pause (Space)", () -> toggle(desk));
        JButton on = button("step-forward", Signs.STEP, "One step on", () -> step(desk, 1));
        JComboBox<Double> rate = new JComboBox<>(RATES);
        rate.setName("playback-rate");
        rate.setToolTipText("World seconds a second");
        if (!List.of(RATES).contains(playback.rate())) {
            rate.addItem(playback.rate());
        }
        rate.setSelectedItem(playback.rate());
        rate.addActionListener(e -> playback.rate((Double) rate.getSelectedItem()));
        slider.setName("time");
        slider.addChangeListener(e -> seek());
        JPanel buttons = new JPanel(new FlowLayout(FlowLayout.LEFT, 4, 0));
        for (var part : new java.awt.Component[] {back, play, on, new JLabel("Rate"), rate}) {
            buttons.add(part);
        }
        time.setName("time-words");
        panel.setBorder(BorderFactory.createEmptyBorder(4, 6, 4, 10));
        panel.add(buttons, BorderLayout.WEST);
        panel.add(slider, BorderLayout.CENTER);
        panel.add(time, BorderLayout.EAST);
        desk.onRefresh(this::refresh);
    }

    JPanel component() {
        return panel;
    }

    /** The same by keys. */
    JMenu menu(Desk desk) {
        JMenu menu = new JMenu("Playback");
        menu.setName("menu-playback");
        menu.setMnemonic('P');
        menu.add(new Act("Play or pause", () -> toggle(desk)).key("SPACE")).setName("play-item");
        menu.add(new Act("One step back", () -> step(desk, -1)).key("COMMA"))
                .setName("step-back-item");
        menu.add(new Act("One step on", () -> step(desk, 1)).key("PERIOD"))
                .setName("step-forward-item");
        return menu;
    }

    static JButton button(String name, Signs sign, String tip, Runnable deed) {
        JButton button = new JButton(sign);
        button.setName(name);
        button.setToolTipText(tip);
        button.setFocusable(false);
        button.addActionListener(e -> deed.run());
        return button;
    }

    private void toggle(Desk desk) {
        playback.play(!playback.isPlaying());
        desk.refresh();
    }

    private void step(Desk desk, int steps) {
        playback.step(steps);
        desk.refresh();
    }

    private void seek() {
        if (!isUpdating) {
            double share = slider.getValue() / (double) PARTS;
            playback.seek(playback.start() + share * (playback.end() - playback.start()));
        }
    }

    private void refresh() {
        double length = playback.end() - playback.start();
        if (!slider.getValueIsAdjusting()) {
            double share = length > 0 ? (playback.time() - playback.start()) / length : 0;
            isUpdating = true;
            slider.setValue((int) Math.round(share * PARTS));
            isUpdating = false;
        }
        play.setIcon(playback.isPlaying() ? Signs.PAUSE : Signs.PLAY);
        time.setText(String.format(Locale.ROOT, "%.2f of %.2f s", playback.time(), playback.end()));
    }
}
