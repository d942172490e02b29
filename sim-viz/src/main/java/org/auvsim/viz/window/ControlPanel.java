package org.auvsim.viz.window;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.message.control.ReleaseControlCommand;
import org.auvsim.auvsml.message.control.TakeControlCommand;
import org.auvsim.core.actuator.Fin;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.viz.scene.ActorView;
import org.auvsim.viz.scene.SeenObject;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.LongConsumer;

import javax.swing.AbstractButton;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JToggleButton;
import javax.swing.ScrollPaneConstants;

/** What can be done with the selected object: its actuators, a force, who controls it. */
final class ControlPanel {
    private final Desk desk;
    private final JPanel panel = new Column();
    private final JScrollPane pane =
            new JScrollPane(
                    panel,
                    ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED,
                    ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
    private Optional<SeenObject> shown = Optional.empty();
    private boolean isAllowed;
    private final List<ActuatorSlider> sliders = new ArrayList<>();
    private boolean isBuilt;
    private Optional<ForcePanel> force = Optional.empty();
    private final JLabel holder = new JLabel();
    private final JButton take;
    private final JButton release;
    private final JToggleButton drive = new JToggleButton("Drive");

    ControlPanel(Desk desk) {
        this.desk = desk;
        panel.setName("control");
        panel.setLayout(new BoxLayout(panel, BoxLayout.Y_AXIS));
        panel.setBorder(BorderFactory.createEmptyBorder(8, 8, 8, 8));
        pane.setBorder(BorderFactory.createEmptyBorder());
        pane.getVerticalScrollBar().setUnitIncrement(16);
        holder.setName("control-holder");
        take = button("take-control", "Take control", id -> desk.ask(new TakeControlCommand(id)));
        release =
                button("release-control", "Release", id -> desk.ask(new ReleaseControlCommand(id)));
        drive.setName("drive-here");
        drive.setFocusable(false);
        drive.addActionListener(e -> desk.drive(drive.isSelected()));
        desk.onRefresh(this::refresh);
    }

    JScrollPane component() {
        return pane;
    }

    private void refresh() {
        Optional<SeenObject> now = desk.selected();
        boolean mayNow = desk.may(Role.CONTROLLER);
        boolean isOther =
                !now.map(SeenObject::id).equals(shown.map(SeenObject::id))
                        || !parts(now).equals(parts(shown));
        if (isBuilt && !isOther && mayNow == isAllowed) {
            now.flatMap(SeenObject::definition)
                    .ifPresent(d -> sliders.forEach(slider -> slider.follow(d)));
            follow();
            return;
        }
        shown = now;
        isAllowed = mayNow;
        isBuilt = true;
        build();
        follow();
    }

    /** Brings up to date who has control, and the force. */
    private void follow() {
        holder.setText(desk.knowsHolders() ? desk.holderWords() : " ");
        holder.setEnabled(isAllowed);
        holder.setToolTipText(desk.hindrance(Role.CONTROLLER).orElse(null));
        hinder(take, desk.hindranceAtTaking(), "Nobody else commands it then");
        hinder(release, desk.hindranceAtRelease(), "Others can take it then");
        hinder(
                drive,
                desk.hindranceAtControlled(Role.CONTROLLER),
                "Drive it by keys: W S A D Q E R F and the arrows; or by gamepad");
        drive.setSelected(desk.isDriving());
        shown.flatMap(o -> desk.scene().lookAt(o.id(), ActorView::forces))
                .ifPresent(forces -> force.ifPresent(panel -> panel.follow(forces)));
    }

    private static void hinder(AbstractButton button, Optional<String> why, String tip) {
        button.setEnabled(why.isEmpty());
        button.setToolTipText(why.orElse(tip));
    }

    /** The names and kinds of its components: their states do not ask for other sliders. */
    private static List<String> parts(Optional<SeenObject> object) {
        return object.flatMap(SeenObject::definition).stream()
                .flatMap(d -> d.component().stream())
                .map(c -> c.getClass().getSimpleName() + " " + c.name())
                .toList();
    }

    private void build() {
        panel.removeAll();
        sliders.clear();
        force = Optional.empty();
        if (shown.isEmpty()) {
            add(new JLabel("Select an object in the list or the picture."));
        } else {
            fill(shown.get());
        }
        panel.add(Box.createVerticalGlue());
        if (!isAllowed) {
            String why = desk.hindrance(Role.CONTROLLER).orElse("");
            disable(panel, why);
            JLabel words = new JLabel("<html><i>" + why + "</i></html>");
            words.setName("control-hindrance");
            words.setAlignmentX(Component.LEFT_ALIGNMENT);
            panel.add(words, 0);
        }
        panel.revalidate();
        panel.repaint();
    }

    private void fill(SeenObject object) {
        JLabel name = new JLabel(object.name());
        name.putClientProperty("FlatLaf.styleClass", "h3");
        add(name);
        add(holder);
        JPanel buttons = new JPanel();
        buttons.setLayout(new BoxLayout(buttons, BoxLayout.X_AXIS));
        buttons.add(take);
        buttons.add(Box.createHorizontalStrut(4));
        buttons.add(release);
        buttons.add(Box.createHorizontalStrut(4));
        buttons.add(drive);
        add(buttons);
        object.definition().ifPresent(definition -> actuators(object.id(), definition));
        if (!object.isFixed()) {
            add(heading("Force"));
            ForcePanel panelOfForce = new ForcePanel(desk, object);
            force = Optional.of(panelOfForce);
            add(panelOfForce.component());
        }
    }

    private void actuators(long id, WorldObjectDefinition definition) {
        var propulsors = definition.component().stream().filter(Propulsor.class::isInstance);
        List<Propulsor> thrusters = propulsors.map(Propulsor.class::cast).toList();
        if (!thrusters.isEmpty()) {
            add(heading("Propulsors (level)"));
            thrusters.forEach(p -> add(ActuatorSlider.of(desk, id, p)));
        }
        var surfaces = definition.component().stream().filter(Fin.class::isInstance);
        List<Fin> fins = surfaces.map(Fin.class::cast).filter(f -> f.maximumAngle() > 0).toList();
        if (!fins.isEmpty()) {
            add(heading("Fins (degrees)"));
            fins.forEach(f -> add(ActuatorSlider.of(desk, id, f)));
        }
    }

    private void add(ActuatorSlider slider) {
        sliders.add(slider);
        add(slider.component());
    }

    private JButton button(String name, String words, LongConsumer deed) {
        JButton button = new JButton(words);
        button.setName(name);
        button.addActionListener(e -> shown.ifPresent(object -> deed.accept(object.id())));
        return button;
    }

    private static JLabel heading(String words) {
        JLabel label = new JLabel(words);
        label.putClientProperty("FlatLaf.styleClass", "h4");
        label.setBorder(BorderFactory.createEmptyBorder(8, 0, 2, 0));
        return label;
    }

    private void add(JComponent part) {
        part.setAlignmentX(Component.LEFT_ALIGNMENT);
        panel.add(part);
    }

    private static void disable(Container all, String why) {
        for (Component part : all.getComponents()) {
            part.setEnabled(false);
            if (part instanceof JComponent swing) {
                swing.setToolTipText(why);
            }
            if (part instanceof Container more) {
                disable(more, why);
            }
        }
    }
}
