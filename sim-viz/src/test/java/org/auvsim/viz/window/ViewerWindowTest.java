package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.message.control.PauseSimulatorCommand;
import org.auvsim.auvsml.message.control.ResumeSimulatorCommand;
import org.auvsim.viz.drawing.Layer;
import org.auvsim.viz.scene.Occurrence;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

import java.util.Optional;
import java.util.OptionalLong;

import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JSlider;
import javax.swing.JTextArea;

/** Somebody watches a simulator or a recording through the window; needs a display. */
@Tag("display")
class ViewerWindowTest {
    @RegisterExtension private final OpenedWindow window = new OpenedWindow();
    private final FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());

    @Test
    void pausesAndGoesOn() throws Exception {
        window.open(simulator);
        window.click("pause");
        assertThat(simulator.asked).containsExactly(new PauseSimulatorCommand());
        simulator.isRunning = false;
        window.click("pause-item");
        assertThat(simulator.asked).last().isEqualTo(new ResumeSimulatorCommand());
    }

    @Test
    void seeksAndSteps() throws Exception {
        FakeRecording recording = new FakeRecording(Scenes.withBuoy());
        window.open(recording);
        Clicks.inSwing(() -> window.find("time", JSlider.class).setValue(5000));
        assertThat(recording.time()).isEqualTo(40);
        window.click("step-back");
        assertThat(recording.time()).isEqualTo(39.5);
        window.click("play");
        assertThat(recording.isPlaying()).isTrue();
        Clicks.inSwing(() -> window.find("playback-rate", JComboBox.class).setSelectedItem(2.0));
        assertThat(recording.rate()).isEqualTo(2);
    }

    @Test
    void choosesViewAndColours() throws Exception {
        window.open(simulator);
        window.click(
                "view-orthographic", "view-top", "show-ghosts-tool", "show-trails", "view-dark");
        assertThat(window.camera().isPerspective()).isFalse();
        assertThat(window.camera().forward(2)).isLessThan(-0.999);
        assertThat(window.view().shows(Layer.GHOSTS)).isFalse();
        assertThat(window.view().shows(Layer.TRAILS)).isFalse();
        assertThat(window.view().isDark()).isFalse();
    }

    @Test
    void aViewerMayNotPauseAndReadsWhy() throws Exception {
        simulator.role = Role.VIEWER;
        window.view().select(OptionalLong.of(9));
        window.open(simulator);
        Clicks.inSwing(
                () -> {
                    for (String name : new String[] {"pause", "shutdown", "apply-force", "drive"}) {
                        AbstractButton button = window.button(name);
                        assertThat(button.isEnabled()).as(name).isFalse();
                        assertThat(button.getToolTipText()).contains("needs the role");
                    }
                });
    }

    @Test
    void tellsOfARefusalUntilSomethingSucceeds() throws Exception {
        simulator.refusal = Optional.of("It is not to be.");
        window.open(simulator);
        window.click("pause");
        Clicks.inSwing(
                () -> {
                    JTextArea log = window.find("log", JTextArea.class);
                    assertThat(log.getText()).endsWith("It is not to be.\n");
                    assertThat(log.getLineWrap()).isTrue();
                    assertThat(words("last-words")).isEqualTo("It is not to be.");
                    assertThat(window.find("status", JLabel.class).isShowing()).isTrue();
                    assertThat(window.find("banner", JLabel.class).isVisible()).isFalse();
                });
        simulator.refusal = Optional.empty();
        window.click("pause");
        Clicks.inSwing(
                () -> {
                    window.turn();
                    assertThat(words("last-words")).isBlank();
                    assertThat(window.find("status", JLabel.class).isShowing()).isTrue();
                });
    }

    @Test
    void tellsOfALostConnectionAndOfNothingOlder() throws Exception {
        simulator.refusal = Optional.of("It is not to be.");
        window.open(simulator);
        window.click("pause");
        simulator.refusal = Optional.empty();
        window.click("pause");
        Clicks.inSwing(window::turn);
        simulator.isConnected = false;
        Clicks.inSwing(
                () -> {
                    window.turn();
                    assertThat(window.find("banner", JLabel.class).isVisible()).isTrue();
                    assertThat(words("banner")).contains("lost");
                    for (String name :
                            new String[] {
                                "status", "last-words", "rate-words", "simulator-words"
                            }) {
                        assertThat(words(name)).as(name).isBlank();
                    }
                    said("The connection to 127.0.0.1:40001 is lost");
                    assertThat(words("last-words")).isBlank();
                    said("The picture is saved.");
                    assertThat(words("last-words")).isEqualTo("The picture is saved.");
                });
    }

    private String words(String label) {
        return window.find(label, JLabel.class).getText();
    }

    private void said(String sentence) {
        simulator.scene().tell(new Occurrence(1, sentence));
        window.turn();
    }

    @Test
    void whatIsSelectedIsWatched() throws Exception {
        window.open(simulator);
        Clicks.inSwing(() -> window.select(9));
        assertThat(simulator.watched).isEqualTo(OptionalLong.of(9));
    }

    @Test
    void whatHasLeftTheWorldIsSelectedNoMoreAndNothingIsDoneWithIt() throws Exception {
        window.view().select(OptionalLong.of(9));
        window.open(simulator);
        Clicks.inSwing(
                () -> {
                    AbstractButton effect = window.button("add-effect");
                    assertThat(effect.isEnabled()).isTrue();
                    simulator.scene().remove(9);
                    window.turn();
                    assertThat(window.view().selected()).isEmpty();
                    assertThat(effect.isEnabled()).isFalse();
                    assertThat(effect.getToolTipText()).contains("Nothing is selected");
                });
    }
}
