package org.auvsim.viz.window;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.SetControlSurfaceCommand;
import org.auvsim.auvsml.message.control.SetPropulsorCommand;
import org.auvsim.core.actuator.Fin;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.Actuator;

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
    private final JPanel panel = new JPanel(new BorderLayout(4, 0));

    private ActuatorSlider(
            Desk desk,
            Actuator actuator,
            double most,
            DoubleFunction<String> words,
            DoubleFunction<Message> message) {
        JSlider slider =
                new JSlider(-PARTS, PARTS, (int) Math.round(actuator.command() / most * PARTS));
        slider.setName("actuator-" + actuator.name());
        JLabel name = new JLabel(actuator.name());
        name.setToolTipText(actuator.name());
        name.setPreferredSize(new Dimension(164, 22));
        JLabel value = new JLabel(words.apply(actuator.command()), SwingConstants.RIGHT);
        value.setPreferredSize(new Dimension(42, 22));
        slider.addChangeListener(
                e -> {
                    double now = most * slider.getValue() / PARTS;
                    value.setText(words.apply(now));
                    desk.outbox().put(slider, message.apply(now));
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
        panel.add(name, BorderLayout.WEST);
        panel.add(slider, BorderLayout.CENTER);
        panel.add(value, BorderLayout.EAST);
        panel.setMaximumSize(new Dimension(Integer.MAX_VALUE, 24));
    }

    static ActuatorSlider of(Desk desk, long id, Propulsor propulsor) {
        return new ActuatorSlider(
                desk,
                propulsor,
                1,
                level -> "%.2f".formatted(level),
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
