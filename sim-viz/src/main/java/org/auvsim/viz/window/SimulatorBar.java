package org.auvsim.viz.window;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.PauseSimulatorCommand;
import org.auvsim.auvsml.message.control.ResumeSimulatorCommand;
import org.auvsim.auvsml.message.control.SetRateCommand;
import org.auvsim.auvsml.message.control.SimulatorStateResponse;
import org.auvsim.auvsml.message.control.StepCommand;
import org.auvsim.viz.scene.Counted;
import org.auvsim.viz.source.Steering;

import java.awt.BorderLayout;
import java.awt.FlowLayout;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;

import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSpinner;
import javax.swing.JTextField;
import javax.swing.SpinnerNumberModel;

/** How the time of a simulator goes on. */
final class SimulatorBar {
    private final Desk desk;
    private final Steering steering;
    private final JPanel panel = new JPanel(new BorderLayout(8, 0));
    private final JButton pause;
    private final JSpinner steps = new JSpinner(new SpinnerNumberModel(1, 1, 1_000_000, 1));
    private final JTextField rate = new JTextField("1.0", 5);
    private final JLabel words = new JLabel(" ");
    private final List<JComponent> parts;

    SimulatorBar(Desk desk, Steering steering) {
        this.desk = desk;
        this.steering = steering;
        pause = PlaybackBar.button("pause", Signs.PAUSE, "", this::toggle);
        JButton step = PlaybackBar.button("step", Signs.STEP, "", this::step);
        steps.setName("steps");
        ((JSpinner.DefaultEditor) steps.getEditor()).getTextField().setColumns(4);
        rate.setName("rate");
        rate.addActionListener(e -> setRate());
        words.setName("simulator-words");
        parts = List.of(pause, step, steps, rate);
        JPanel controls = new JPanel(new FlowLayout(FlowLayout.LEFT, 4, 0));
        controls.add(pause);
        controls.add(step);
        controls.add(steps);
        controls.add(new JLabel("steps"));
        controls.add(new JLabel("   Rate"));
        controls.add(rate);
        panel.setBorder(BorderFactory.createEmptyBorder(4, 6, 4, 10));
        panel.add(controls, BorderLayout.WEST);
        panel.add(words, BorderLayout.EAST);
        desk.onRefresh(this::refresh);
    }

    JPanel component() {
        return panel;
    }

    private boolean isRunning() {
        return steering.state().map(SimulatorStateResponse::running).orElse(true);
    }

    /** Pauses, or lets time go on. */
    void toggle() {
        desk.ask(isRunning() ? new PauseSimulatorCommand() : new ResumeSimulatorCommand());
    }

    /** Makes the chosen number of steps. */
    void step() {
        desk.ask(new StepCommand((Integer) steps.getValue()));
    }

    private void setRate() {
        checked(() -> new SetRateCommand(rate.getText().strip())).ifPresent(desk::ask);
    }

    private Optional<Message> checked(Supplier<Message> message) {
        try {
            return Optional.of(message.get());
        } catch (IllegalArgumentException e) {
            desk.say(Desk.sentence(e));
            return Optional.empty();
        }
    }

    private void refresh() {
        Optional<String> hindrance = desk.hindrance(Role.ADMIN);
        for (JComponent part : parts) {
            part.setEnabled(hindrance.isEmpty());
            part.setToolTipText(hindrance.orElse(tip(part)));
        }
        pause.setIcon(isRunning() ? Signs.PAUSE : Signs.PLAY);
        Optional<SimulatorStateResponse> state =
                desk.isLost() ? Optional.empty() : steering.state();
        state.ifPresentOrElse(this::show, () -> words.setText(" "));
    }

    private String tip(JComponent part) {
        if (part.equals(pause)) {
            return isRunning() ? "Pause (Space)" : "Go on (Space)";
        }
        return part.equals(rate) ? "World seconds a second, or max; Enter sets it" : "Make steps";
    }

    private void show(SimulatorStateResponse state) {
        if (!rate.isFocusOwner()) {
            rate.setText(state.rate());
        }
        words.setText(
                String.format(
                        Locale.ROOT,
                        "%.2f s   step %d   %s   %s",
                        state.time(),
                        state.step(),
                        state.running() ? "running" : "paused",
                        Counted.of(state.clients(), "client")));
    }
}
