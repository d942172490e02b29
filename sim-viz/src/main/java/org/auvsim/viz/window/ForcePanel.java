package org.auvsim.viz.window;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.ApplyDirectForceCommand;
import org.auvsim.auvsml.message.control.ApplyForceCommand;
import org.auvsim.auvsml.message.control.RemoveForceCommand;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Vec3;
import org.auvsim.viz.driving.Driving;
import org.auvsim.viz.scene.SeenObject;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.GridLayout;
import java.awt.Insets;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Locale;

import javax.swing.DefaultListCellRenderer;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.SpinnerNumberModel;

/** A force on an object, in newtons, and where it acts. */
final class ForcePanel {
    private static final String[] AXES = {"x", "y", "z"};

    /** A slider goes so many steps either way. */
    private static final int PARTS = 10;

    private final Desk desk;
    private final long id;
    private final JSpinner[] force = new JSpinner[AXES.length];
    private final JSpinner[] point = new JSpinner[AXES.length];
    private final JComboBox<Frame> frame = new JComboBox<>(Frame.values());
    private final JPanel panel = new JPanel(new GridLayout(0, 4, 4, 4));

    ForcePanel(Desk desk, SeenObject object) {
        this.desk = desk;
        id = object.id();
        double step =
                object.definition()
                        .flatMap(d -> d.mass().stream().boxed().findFirst())
                        .map(ForcePanel::round)
                        .orElse(1.0);
        row("Force N", "force-", force, step);
        sliders(step);
        row("Point m", "point-", point, 0.1);
        frame.setName("force-frame");
        frame.setRenderer(
                new DefaultListCellRenderer() {
                    private static final long serialVersionUID = 1L;

                    @Override
                    public Component getListCellRendererComponent(
                            JList<?> list, Object value, int at, boolean is, boolean has) {
                        String word = value.toString().toLowerCase(Locale.ROOT);
                        return super.getListCellRendererComponent(list, word, at, is, has);
                    }
                });
        frame.setToolTipText("The axes of the force; the point is always in the body's");
        panel.add(new JLabel("Axes"));
        panel.add(frame);
        panel.add(button("apply-force", "Apply", this::apply));
        panel.add(button("remove-force", "Remove", this::remove));
        panel.setMaximumSize(new Dimension(Integer.MAX_VALUE, 120));
    }

    JPanel component() {
        return panel;
    }

    /** A power of ten near to a mass times 1 m/s^2. */
    private static double round(double mass) {
        return Math.pow(10, Math.rint(Math.log10(Math.max(mass, 1e-3))));
    }

    private void row(String words, String name, JSpinner[] spinners, double step) {
        panel.add(new JLabel(words));
        for (int axis = 0; axis < AXES.length; axis++) {
            JSpinner spinner = new JSpinner(new SpinnerNumberModel(0.0, -1e9, 1e9, step));
            spinner.setName(name + AXES[axis]);
            spinner.setToolTipText(AXES[axis]);
            ((JSpinner.DefaultEditor) spinner.getEditor()).getTextField().setColumns(4);
            spinners[axis] = spinner;
            panel.add(spinner);
        }
    }

    /** What a slider is moved to acts at once; a double click ends it. */
    private void sliders(double step) {
        panel.add(new JLabel("Push"));
        for (int axis = 0; axis < AXES.length; axis++) {
            JSpinner spinner = force[axis];
            JSlider slider = new JSlider(-PARTS, PARTS, 0);
            slider.setName("push-" + AXES[axis]);
            slider.setToolTipText(
                    String.format(
                            Locale.ROOT,
                            "%s: up to %.4g N either way, at once",
                            AXES[axis],
                            PARTS * step));
            slider.setPreferredSize(new Dimension(60, 22));
            slider.addChangeListener(
                    e -> {
                        spinner.setValue(slider.getValue() * step);
                        desk.outbox().put(this, message());
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
            panel.add(slider);
        }
    }

    private static JButton button(String name, String words, Runnable deed) {
        JButton button = new JButton(words);
        button.setName(name);
        button.setMargin(new Insets(2, 2, 2, 2));
        button.addActionListener(e -> deed.run());
        return button;
    }

    private static Vec3 vector(JSpinner... spinners) {
        return new Vec3(
                (Double) spinners[0].getValue(),
                (Double) spinners[1].getValue(),
                (Double) spinners[2].getValue());
    }

    private Message message() {
        Vec3 at = vector(point);
        Frame axes = (Frame) frame.getSelectedItem();
        return at.equals(Vec3.ZERO)
                ? new ApplyDirectForceCommand(id, Driving.FORCE, axes, vector(force))
                : new ApplyForceCommand(id, Driving.FORCE, axes, vector(force), at);
    }

    private void apply() {
        desk.ask(message());
    }

    private void remove() {
        desk.ask(new RemoveForceCommand(id, Driving.FORCE));
    }
}
