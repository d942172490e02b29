package org.auvsim.viz.window;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.ApplyDirectForceCommand;
import org.auvsim.auvsml.message.control.ApplyForceCommand;
import org.auvsim.auvsml.message.control.RemoveForceCommand;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.math.Vec3;
import org.auvsim.viz.driving.Driving;
import org.auvsim.viz.scene.SeenObject;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.GridLayout;
import java.awt.Insets;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

import javax.swing.DefaultListCellRenderer;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.SpinnerNumberModel;
import javax.swing.SwingConstants;

/** A force on an object, in newtons, and where it acts. */
final class ForcePanel {
    private static final String[] AXES = {"x", "y", "z"};

    /**
     * What was sent is left alone for so long (ns): the simulator is asked for forces now and then,
     * and what it told last may be older than its answer to what was sent.
     */
    private static final long LEFT_ALONE = 1_500_000_000L;

    /** A slider goes so many steps either way. */
    private static final int PARTS = 10;

    private final Desk desk;
    private final long id;
    private final double step;
    private final JSpinner[] force = new JSpinner[AXES.length];
    private final JSlider[] push = new JSlider[AXES.length];
    private final JSpinner[] point = new JSpinner[AXES.length];
    private final JComboBox<Frame> frame = new JComboBox<>(Frame.values());
    private final JPanel panel = new JPanel(new GridLayout(0, 4, 4, 4));

    /** The force that stands here, as it is in the world or is about to be. */
    private Optional<NamedForce> shown = Optional.empty();

    private boolean isFollowing;
    private long sent = System.nanoTime() - LEFT_ALONE;

    ForcePanel(Desk desk, SeenObject object) {
        this.desk = desk;
        id = object.id();
        step =
                object.definition()
                        .flatMap(d -> d.mass().stream().boxed().findFirst())
                        .map(ForcePanel::round)
                        .orElse(1.0);
        headings();
        row("Force N", "force-", force, step);
        sliders();
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
        panel.setMaximumSize(new Dimension(Integer.MAX_VALUE, 144));
    }

    JPanel component() {
        return panel;
    }

    /** A power of ten near to a mass times 1 m/s^2. */
    private static double round(double mass) {
        return Math.pow(10, Math.rint(Math.log10(Math.max(mass, 1e-3))));
    }

    private void headings() {
        panel.add(new JLabel());
        for (String axis : AXES) {
            panel.add(new JLabel(axis, SwingConstants.CENTER));
        }
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
    private void sliders() {
        String most = String.format(Locale.ROOT, "\u00b1%.4g N", PARTS * step);
        JLabel label = new JLabel("Push N");
        label.setToolTipText("Acts at once, " + most);
        panel.add(label);
        for (int axis = 0; axis < AXES.length; axis++) {
            JSpinner spinner = force[axis];
            JSlider slider = new JSlider(-PARTS, PARTS, 0);
            push[axis] = slider;
            slider.setName("push-" + AXES[axis]);
            slider.setToolTipText(AXES[axis] + ": acts at once, " + most);
            slider.setPreferredSize(new Dimension(60, 22));
            slider.addChangeListener(
                    e -> {
                        if (!isFollowing) {
                            spinner.setValue(slider.getValue() * step);
                            NamedForce now = force();
                            show(Optional.of(now));
                            sent = System.nanoTime();
                            desk.outbox().put(this, command(now));
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
            panel.add(slider);
        }
    }

    /** Shows the force that there is, once it is another one; what is typed in stays until then. */
    void follow(List<NamedForce> forces) {
        Optional<NamedForce> now =
                forces.stream().filter(f -> f.name().equals(Driving.FORCE)).findFirst();
        boolean isMoving = Stream.of(push).anyMatch(JSlider::getValueIsAdjusting);
        if (!now.equals(shown) && !isMoving && System.nanoTime() - sent >= LEFT_ALONE) {
            show(now);
        }
    }

    private void show(Optional<NamedForce> now) {
        isFollowing = true;
        shown = now;
        set(force, now.map(NamedForce::vector).orElse(Vec3.ZERO));
        now.ifPresent(
                there -> {
                    set(point, there.point());
                    frame.setSelectedItem(there.frame());
                });
        for (int axis = 0; axis < AXES.length; axis++) {
            push[axis].setValue((int) Math.rint((Double) force[axis].getValue() / step));
        }
        isFollowing = false;
    }

    private static void set(JSpinner[] spinners, Vec3 to) {
        spinners[0].setValue(to.x());
        spinners[1].setValue(to.y());
        spinners[2].setValue(to.z());
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

    /** What the fields say. */
    private NamedForce force() {
        return new NamedForce(
                Driving.FORCE, (Frame) frame.getSelectedItem(), vector(force), vector(point));
    }

    private Message command(NamedForce to) {
        return to.point().equals(Vec3.ZERO)
                ? new ApplyDirectForceCommand(id, to.name(), to.frame(), to.vector())
                : new ApplyForceCommand(id, to.name(), to.frame(), to.vector(), to.point());
    }

    private void apply() {
        NamedForce now = force();
        send(Optional.of(now), command(now));
    }

    private void remove() {
        send(Optional.empty(), new RemoveForceCommand(id, Driving.FORCE));
    }

    private void send(Optional<NamedForce> now, Message command) {
        show(now);
        sent = System.nanoTime();
        desk.ask(command);
    }
}
