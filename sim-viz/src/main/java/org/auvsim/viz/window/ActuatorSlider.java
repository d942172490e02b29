package org.auvsim.viz.window;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.SetControlSurfaceCommand;
import org.auvsim.auvsml.message.control.SetPropulsorCommand;
import org.auvsim.core.actuator.Fin;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.Actuator;
import org.auvsim.core.entity.WorldObjectDefinition;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Locale;
import java.util.function.DoubleFunction;

import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.SwingConstants;

/** A slider for one actuator; a double click brings it to its middle. */
final class ActuatorSlider {
    private static final int PARTS = 100;

    /** A slider that was moved is left alone until what it sent has come back (ns). */
    private static final long LEFT_ALONE = 1_500_000_000L;

    private final JPanel panel = new JPanel(new BorderLayout(4, 0));
    private final JSlider slider;
    private final String name;
    private final double most;
    private boolean isFollowing;
    private long moved = System.nanoTime() - LEFT_ALONE;

    private ActuatorSlider(
            Desk desk,
            Actuator actuator,
            double most,
            DoubleFunction<String> words,
            DoubleFunction<Message> message) {
        this.name = actuator.name();
        this.most = most;
        slider = new JSlider(-PARTS, PARTS, place(actuator.command()));
        slider.setName("actuator-" + actuator.name());
        JLabel label = new JLabel(actuator.name());
        label.setToolTipText(actuator.name());
        label.setPreferredSize(new Dimension(164, 22));
        JLabel value = new JLabel(words.apply(actuator.command()), SwingConstants.RIGHT);
        int widest = value.getFontMetrics(value.getFont()).stringWidth(words.apply(-most));
        value.setPreferredSize(new Dimension(Math.max(42, widest + 4), 22));
        slider.addChangeListener(
                e -> {
                    double now = most * slider.getValue() / PARTS;
                    value.setText(words.apply(now));
                    if (!isFollowing) {
                        moved = System.nanoTime();
                        desk.outbox().put(slider, message.apply(now));
                    }
                });
        slider.addMouseListener(
                new MouseAdapter() {
                    @Override
                    public void mouseClicked(MouseEvent e) {
                        if (e.getClickCount() == 2 && slider.isEnabled()) {
                            slider.setValue(0);
                        }
                    }
                });
        slider.setPreferredSize(new Dimension(80, 22));
        panel.add(label, BorderLayout.WEST);
        panel.add(slider, BorderLayout.CENTER);
        panel.add(value, BorderLayout.EAST);
        panel.setMaximumSize(new Dimension(Integer.MAX_VALUE, 24));
    }

    /** Stands where others, or keys and gamepad, have brought the actuator of a definition. */
    void follow(WorldObjectDefinition definition) {
        if (slider.getValueIsAdjusting() || System.nanoTime() - moved < LEFT_ALONE) {
            return;
        }
        isFollowing = true;
        definition.component().stream()
                .filter(c -> c instanceof Actuator && c.name().equals(name))
                .forEach(c -> slider.setValue(place(((Actuator) c).command())));
        isFollowing = false;
    }

    private int place(double command) {
        return (int) Math.round(command / most * PARTS);
    }

    static ActuatorSlider of(Desk desk, long id, Propulsor propulsor) {
        return new ActuatorSlider(
                desk,
                propulsor,
                1,
                level -> String.format(Locale.ROOT, "%.2f", level),
                level -> new SetPropulsorCommand(id, propulsor.name(), level));
    }

    static ActuatorSlider of(Desk desk, long id, Fin fin) {
        return new ActuatorSlider(
                desk,
                fin,
                fin.maximumAngle(),
                angle -> String.format(Locale.ROOT, "%.1f\u00b0", Math.toDegrees(angle)),
                angle -> new SetControlSurfaceCommand(id, fin.name(), angle));
    }

    JPanel component() {
        return panel;
    }
}
