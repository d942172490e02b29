package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.message.command.ListedClient;
import org.auvsim.auvsml.message.control.ApplyDirectForceCommand;
import org.auvsim.auvsml.message.control.RemoveForceCommand;
import org.auvsim.auvsml.message.control.SetPropulsorCommand;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.viz.scene.SeenObject;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

import java.util.List;

import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JSlider;
import javax.swing.JSpinner;

/** Somebody steers the selected object by the tab beside the picture; needs a display. */
@Tag("display")
class ControlPanelTest {
    @RegisterExtension private final OpenedWindow window = new OpenedWindow();
    private final FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());

    private JSpinner field(String name) {
        return window.find(name, JSpinner.class);
    }

    private JSlider slider(String name) {
        return window.find(name, JSlider.class);
    }

    @Test
    void appliesAForce() throws Exception {
        window.openAtControl(simulator, 9);
        Clicks.inSwing(
                () -> {
                    field("force-x").setValue(3.0);
                    field("force-z").setValue(-1.5);
                    window.find("force-frame", JComboBox.class).setSelectedItem(Frame.BODY);
                    window.button("apply-force").doClick(0);
                });
        assertThat(simulator.asked)
                .containsExactly(
                        new ApplyDirectForceCommand(9, "Viewer", Frame.BODY, new Vec3(3, 0, -1.5)));
    }

    @Test
    void aForceIsPushedByItsSlider() throws Exception {
        window.openAtControl(simulator, 9);
        Clicks.inSwing(
                () -> {
                    slider("push-y").setValue(-1);
                    slider("push-y").setValue(-3);
                    window.turn();
                });
        // Steps of 10 N for a buoy of 20 kg.
        assertThat(simulator.asked)
                .containsExactly(
                        new ApplyDirectForceCommand(9, "Viewer", Frame.WORLD, new Vec3(0, -30, 0)));
    }

    @Test
    void fieldsAndSlidersStandForTheForceThatThereIs() throws Exception {
        window.openAtControl(simulator, 9);
        Clicks.inSwing(
                () -> {
                    JSpinner field = field("force-x");
                    JSlider push = slider("push-x");
                    push.setValue(5);
                    window.turn();
                    field.setValue(25.0);
                    window.button("apply-force").doClick(0);
                    assertThat(push.getValue()).isEqualTo(2); // of 10 N each
                    window.button("remove-force").doClick(0);
                    assertThat(field.getValue()).isEqualTo(0.0);
                    assertThat(push.getValue()).isZero();
                });
        assertThat(simulator.asked).hasSize(3).last().isInstanceOf(RemoveForceCommand.class);
    }

    @Test
    void theForceThatSomebodyElseHasSetIsShown() throws Exception {
        window.openAtControl(simulator, 9);
        Vec3 vector = new Vec3(0, 0, -40);
        Clicks.inSwing(
                () -> {
                    simulator
                            .scene()
                            .setForces(9, List.of(NamedForce.direct("Viewer", Frame.BODY, vector)));
                    window.turn();
                    assertThat(field("force-z").getValue()).isEqualTo(-40.0);
                    assertThat(slider("push-z").getValue()).isEqualTo(-4);
                });
        assertThat(simulator.asked).isEmpty();
    }

    @Test
    void aSliderSendsItsLastPlaceAlone() throws Exception {
        FakeSimulator rov = new FakeSimulator(Scenes.of("bluerov2-dive.xml"));
        window.openAtControl(rov, 1);
        Clicks.inSwing(
                () -> {
                    JSlider slider = slider("actuator-Aft Port");
                    slider.setValue(20);
                    slider.setValue(50);
                    slider.setValue(75);
                    window.turn();
                });
        assertThat(rov.asked).containsExactly(new SetPropulsorCommand(1, "Aft Port", 0.75));
    }

    @Test
    void aSliderStandsWhereSomebodyElseHasBroughtIt() throws Exception {
        FakeSimulator rov = new FakeSimulator(Scenes.of("bluerov2-dive.xml"));
        window.openAtControl(rov, 1);
        WorldObjectDefinition told =
                rov.scene().object(1).flatMap(SeenObject::definition).orElseThrow();
        List<Component> components =
                told.component().stream()
                        .map(c -> c instanceof Propulsor p ? p.commanded(0.4, 0) : c)
                        .toList();
        Clicks.inSwing(
                () -> {
                    window.turn();
                    rov.scene()
                            .add(SeenObject.of(1, told.toBuilder().components(components).build()));
                    window.turn();
                    assertThat(slider("actuator-Aft Port").getValue()).isEqualTo(40);
                });
        assertThat(rov.asked).isEmpty();
    }

    @Test
    void tellsWhoHasControlAndOffersWhatMakesSense() throws Exception {
        window.openAtControl(simulator, 9);
        control(" ", true, false, true);
        assertThat(hindranceAtRelease()).isEqualTo("Who controls it is not known yet.");
        simulator.clients = List.of(client(3, "Viewer 3", 10));
        control("Nobody controls it.", true, false, true);
        assertThat(hindranceAtRelease()).isEqualTo("Nobody controls it.");
        simulator.clients = List.of(client(3, "Viewer 3", 9));
        control("This viewer controls it.", false, true, true);
        simulator.clients = List.of(client(4, "REMUS", 9));
        control("REMUS controls it.", false, false, false);
        simulator.isConnected = false;
        control(" ", false, false, false);
        assertThat(holder().isEnabled()).isFalse();
        simulator.isConnected = true;
        control("REMUS controls it.", false, false, false);
        assertThat(holder().isEnabled()).isTrue();
        assertThat(holder().getToolTipText()).isNull();
    }

    @Test
    void aRecordingDoesNotTellWhoHasControl() throws Exception {
        window.openAtControl(new FakeRecording(Scenes.withBuoy()), 9);
        Clicks.inSwing(() -> assertThat(holder().getText()).isBlank());
    }

    private JLabel holder() {
        return window.find("control-holder", JLabel.class);
    }

    private String hindranceAtRelease() {
        return window.button("release-control").getToolTipText();
    }

    private static ListedClient client(long session, String name, long object) {
        var held = List.of(new ListedClient.ControlledObject(object));
        return new ListedClient(session, name, "127.0.0.1:5", "controller", false, held);
    }

    private void control(String holder, boolean take, boolean release, boolean drive)
            throws Exception {
        Clicks.inSwing(
                () -> {
                    window.turn();
                    assertThat(holder().getText()).isEqualTo(holder);
                    isEnabled(take, "take-control", "take-control-item");
                    isEnabled(release, "release-control", "release-control-item");
                    isEnabled(drive, "drive-here", "drive");
                });
    }

    private void isEnabled(boolean enabled, String... names) {
        for (String name : names) {
            assertThat(window.button(name).isEnabled()).as(name).isEqualTo(enabled);
        }
    }
}
