package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.message.command.ListedClient;
import org.auvsim.auvsml.message.control.ApplyDirectForceCommand;
import org.auvsim.auvsml.message.control.PauseSimulatorCommand;
import org.auvsim.auvsml.message.control.RemoveForceCommand;
import org.auvsim.auvsml.message.control.ResetCommand;
import org.auvsim.auvsml.message.control.RestoreSnapshotCommand;
import org.auvsim.auvsml.message.control.ResumeSimulatorCommand;
import org.auvsim.auvsml.message.control.SetPropulsorCommand;
import org.auvsim.auvsml.message.control.ShutdownSimulatorCommand;
import org.auvsim.auvsml.message.entity.AddEffectCommand;
import org.auvsim.auvsml.message.entity.RemoveEntityCommand;
import org.auvsim.auvsml.message.session.DisconnectClientCommand;
import org.auvsim.auvsml.message.session.ListClientsRequest;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.drawing.Layer;
import org.auvsim.viz.drawing.ViewOptions;
import org.auvsim.viz.scene.Movement;
import org.auvsim.viz.scene.Occurrence;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;
import org.auvsim.viz.source.Source;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.awt.Component;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;

/** Somebody clicks through the window; needs a display. */
@Tag("display")
class ViewerWindowTest {
    private final OrbitCamera camera = new OrbitCamera();
    private final ViewOptions view = new ViewOptions();
    private Optional<ViewerWindow> window = Optional.empty();

    @AfterEach
    void close() throws Exception {
        Clicks.inSwing(() -> window.ifPresent(ViewerWindow::close));
    }

    @Test
    void pausesAndGoesOn() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.of("bluerov2-dive.xml"));
        open(simulator);
        Clicks.inSwing(() -> find("pause", AbstractButton.class).doClick(0));
        assertThat(simulator.asked).containsExactly(new PauseSimulatorCommand());
        simulator.isRunning = false;
        Clicks.inSwing(() -> find("pause-item", AbstractButton.class).doClick(0));
        assertThat(simulator.asked).last().isEqualTo(new ResumeSimulatorCommand());
    }

    @Test
    void selectsInTheListAndInThePicture() throws Exception {
        open(new FakeSimulator(Scenes.of("bluerov2-dive.xml")));
        Clicks.inSwing(
                () -> {
                    JTable objects = find("objects", JTable.class);
                    find("filter", JTextField.class).setText("rov");
                    assertThat(objects.getRowCount()).isEqualTo(2);
                    objects.setRowSelectionInterval(1, 1);
                    assertThat(view.selected()).isEqualTo(OptionalLong.of(1));
                    find("filter", JTextField.class).setText("");
                    camera.aim(5, 0, 0, 20);
                    Component screen = find("screen", Component.class);
                    Clicks.click(screen, screen.getWidth() / 2, screen.getHeight() / 2);
                });
        assertThat(view.selected()).isEqualTo(OptionalLong.of(9));
        Clicks.inSwing(
                () -> {
                    JTable objects = find("objects", JTable.class);
                    int row = objects.getSelectedRow();
                    assertThat(objects.getValueAt(row, 0)).isEqualTo("Buoy");
                });
    }

    @Test
    void whatIsSelectedIsWatched() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
        open(simulator);
        view.select(OptionalLong.of(9));
        Clicks.inSwing(() -> window.orElseThrow().turn());
        assertThat(simulator.watched).isEqualTo(OptionalLong.of(9));
    }

    @Test
    void whatIsSelectedInThePictureIsUnfoldedInTheTree() throws Exception {
        open(new FakeSimulator(Scenes.withBuoy()));
        Clicks.inSwing(
                () -> {
                    JTable objects = find("objects", JTable.class);
                    Clicks.click(objects, 4, objects.getRowHeight() / 2);
                    assertThat(objects.getRowCount()).isEqualTo(1);
                    view.select(OptionalLong.of(9));
                    window.orElseThrow().turn();
                    assertThat(objects.getRowCount()).isEqualTo(2);
                    assertThat(objects.getSelectedRow()).isEqualTo(1);
                });
    }

    @Test
    void aListInOrderOfDistanceStaysWhereItIsScrolledAndKeepsItsRow() throws Exception {
        Scene scene = Scenes.withBuoy();
        WorldObjectDefinition rock =
                WorldObjectDefinition.named("Rock").fixed().volume(new Sphere(1)).build();
        for (long id = 10; id < 200; id++) {
            scene.add(SeenObject.of(id, rock));
        }
        open(new FakeSimulator(scene));
        Clicks.inSwing(
                () -> {
                    JTable objects = find("objects", JTable.class);
                    select(9);
                    objects.getRowSorter().toggleSortOrder(ObjectRows.DISTANCE);
                    assertThat(objects.getValueAt(objects.getSelectedRow(), 0)).isEqualTo("Buoy");
                    int last = objects.getRowCount() - 1;
                    objects.scrollRectToVisible(objects.getCellRect(last, 0, true));
                    Rectangle seen = objects.getVisibleRect();
                    assertThat(seen.y).isPositive();
                    turnOften();
                    assertThat(objects.getVisibleRect()).isEqualTo(seen);
                    assertThat(objects.getValueAt(objects.getSelectedRow(), 0)).isEqualTo("Buoy");
                });
    }

    @Test
    void aListInOrderKeepsTheRowTheKeyboardIsOnThoughNothingIsSelected() throws Exception {
        open(new FakeSimulator(Scenes.withBuoy()));
        Clicks.inSwing(
                () -> {
                    JTable objects = find("objects", JTable.class);
                    objects.getRowSorter().toggleSortOrder(ObjectRows.SPEED);
                    objects.setRowSelectionInterval(0, 0);
                    turnOften();
                    assertThat(view.selected()).isEmpty();
                    assertThat(objects.getSelectedRow()).isZero();
                });
    }

    /** So often that what moves is put in order again. */
    private void turnOften() {
        for (int turn = 0; turn < 20; turn++) {
            window.orElseThrow().turn();
        }
    }

    @Test
    void appliesAForce() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
        view.select(OptionalLong.of(9));
        open(simulator);
        Clicks.inSwing(
                () -> {
                    find("right", JTabbedPane.class).setSelectedIndex(1);
                    find("force-x", JSpinner.class).setValue(3.0);
                    find("force-z", JSpinner.class).setValue(-1.5);
                    find("force-frame", JComboBox.class).setSelectedItem(Frame.BODY);
                    find("apply-force", AbstractButton.class).doClick(0);
                });
        assertThat(simulator.asked)
                .containsExactly(
                        new ApplyDirectForceCommand(9, "Viewer", Frame.BODY, new Vec3(3, 0, -1.5)));
    }

    @Test
    void aForceIsPushedByItsSlider() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
        view.select(OptionalLong.of(9));
        open(simulator);
        Clicks.inSwing(
                () -> {
                    find("right", JTabbedPane.class).setSelectedIndex(1);
                    find("push-y", JSlider.class).setValue(-1);
                    find("push-y", JSlider.class).setValue(-3);
                    window.orElseThrow().turn();
                });
        // Steps of 10 N for a buoy of 20 kg.
        assertThat(simulator.asked)
                .containsExactly(
                        new ApplyDirectForceCommand(9, "Viewer", Frame.WORLD, new Vec3(0, -30, 0)));
    }

    @Test
    void fieldsAndSlidersStandForTheForceThatThereIs() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
        view.select(OptionalLong.of(9));
        open(simulator);
        Clicks.inSwing(
                () -> {
                    find("right", JTabbedPane.class).setSelectedIndex(1);
                    JSpinner field = find("force-x", JSpinner.class);
                    JSlider push = find("push-x", JSlider.class);
                    push.setValue(5);
                    window.orElseThrow().turn();
                    field.setValue(25.0);
                    find("apply-force", AbstractButton.class).doClick(0);
                    assertThat(push.getValue()).isEqualTo(2); // of 10 N each
                    find("remove-force", AbstractButton.class).doClick(0);
                    assertThat(field.getValue()).isEqualTo(0.0);
                    assertThat(push.getValue()).isZero();
                });
        assertThat(simulator.asked).hasSize(3).last().isInstanceOf(RemoveForceCommand.class);
    }

    @Test
    void theForceThatSomebodyElseHasSetIsShown() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
        view.select(OptionalLong.of(9));
        open(simulator);
        Vec3 vector = new Vec3(0, 0, -40);
        Clicks.inSwing(
                () -> {
                    find("right", JTabbedPane.class).setSelectedIndex(1);
                    simulator
                            .scene()
                            .setForces(9, List.of(NamedForce.direct("Viewer", Frame.BODY, vector)));
                    window.orElseThrow().turn();
                    assertThat(find("force-z", JSpinner.class).getValue()).isEqualTo(-40.0);
                    assertThat(find("push-z", JSlider.class).getValue()).isEqualTo(-4);
                });
        assertThat(simulator.asked).isEmpty();
    }

    @Test
    void tellsWhoHasControlAndOffersWhatMakesSense() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
        view.select(OptionalLong.of(9));
        open(simulator);
        Clicks.inSwing(() -> find("right", JTabbedPane.class).setSelectedIndex(1));
        control(" ", true, false, true);
        simulator.clients = List.of(client(3, "Viewer 3", 10));
        control("Nobody controls it.", true, false, true);
        simulator.clients = List.of(client(3, "Viewer 3", 9));
        control("This viewer controls it.", false, true, true);
        simulator.clients = List.of(client(4, "REMUS", 9));
        control("REMUS controls it.", false, false, false);
        simulator.isConnected = false;
        control(" ", false, false, false);
        assertThat(find("control-holder", JLabel.class).isEnabled()).isFalse();
        simulator.isConnected = true;
        control("REMUS controls it.", false, false, false);
        assertThat(find("control-holder", JLabel.class).isEnabled()).isTrue();
        assertThat(find("control-holder", JLabel.class).getToolTipText()).isNull();
    }

    @Test
    void aRecordingDoesNotTellWhoHasControl() throws Exception {
        view.select(OptionalLong.of(9));
        open(new FakeRecording(Scenes.withBuoy()));
        Clicks.inSwing(
                () -> {
                    find("right", JTabbedPane.class).setSelectedIndex(1);
                    assertThat(find("control-holder", JLabel.class).getText()).isBlank();
                });
    }

    private static ListedClient client(long session, String name, long object) {
        var held = List.of(new ListedClient.ControlledObject(object));
        return new ListedClient(session, name, "127.0.0.1:5", "controller", false, held);
    }

    private void control(String holder, boolean take, boolean release, boolean drive)
            throws Exception {
        Clicks.inSwing(
                () -> {
                    window.orElseThrow().turn();
                    assertThat(find("control-holder", JLabel.class).getText()).isEqualTo(holder);
                    for (String name : new String[] {"take-control", "take-control-item"}) {
                        assertThat(find(name, AbstractButton.class).isEnabled()).isEqualTo(take);
                    }
                    for (String name : new String[] {"release-control", "release-control-item"}) {
                        assertThat(find(name, AbstractButton.class).isEnabled()).isEqualTo(release);
                    }
                    for (String name : new String[] {"drive-here", "drive"}) {
                        assertThat(find(name, AbstractButton.class).isEnabled()).isEqualTo(drive);
                    }
                });
    }

    @Test
    void aSliderSendsItsLastPlaceAlone() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.of("bluerov2-dive.xml"));
        view.select(OptionalLong.of(1));
        open(simulator);
        Clicks.inSwing(
                () -> {
                    find("right", JTabbedPane.class).setSelectedIndex(1);
                    JSlider slider = find("actuator-Aft Port", JSlider.class);
                    slider.setValue(20);
                    slider.setValue(50);
                    slider.setValue(75);
                    window.orElseThrow().turn();
                });
        assertThat(simulator.asked).containsExactly(new SetPropulsorCommand(1, "Aft Port", 0.75));
    }

    @Test
    void aSliderStandsWhereSomebodyElseHasBroughtIt() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.of("bluerov2-dive.xml"));
        view.select(OptionalLong.of(1));
        open(simulator);
        SeenObject rov = simulator.scene().object(1).orElseThrow();
        WorldObjectDefinition told = rov.definition().orElseThrow();
        List<org.auvsim.core.entity.Component> components =
                told.component().stream()
                        .map(c -> c instanceof Propulsor p ? p.commanded(0.4, 0) : c)
                        .toList();
        Clicks.inSwing(
                () -> {
                    find("right", JTabbedPane.class).setSelectedIndex(1);
                    window.orElseThrow().turn();
                    simulator
                            .scene()
                            .add(SeenObject.of(1, told.toBuilder().components(components).build()));
                    window.orElseThrow().turn();
                    JSlider slider = find("actuator-Aft Port", JSlider.class);
                    assertThat(slider.getValue()).isEqualTo(40);
                });
        assertThat(simulator.asked).isEmpty();
    }

    @Test
    void seeksAndSteps() throws Exception {
        FakeRecording recording = new FakeRecording(Scenes.withBuoy());
        open(recording);
        Clicks.inSwing(() -> find("time", JSlider.class).setValue(5000));
        assertThat(recording.time()).isEqualTo(40);
        Clicks.inSwing(() -> find("step-back", AbstractButton.class).doClick(0));
        assertThat(recording.time()).isEqualTo(39.5);
        Clicks.inSwing(() -> find("play", AbstractButton.class).doClick(0));
        assertThat(recording.isPlaying()).isTrue();
        Clicks.inSwing(() -> find("playback-rate", JComboBox.class).setSelectedItem(2.0));
        assertThat(recording.rate()).isEqualTo(2);
    }

    @Test
    void aViewerMayNotPauseAndReadsWhy() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
        simulator.role = Role.VIEWER;
        view.select(OptionalLong.of(9));
        open(simulator);
        Clicks.inSwing(
                () -> {
                    for (String name : new String[] {"pause", "shutdown", "apply-force", "drive"}) {
                        AbstractButton button = find(name, AbstractButton.class);
                        assertThat(button.isEnabled()).as(name).isFalse();
                        assertThat(button.getToolTipText()).contains("needs the role");
                    }
                });
    }

    @Test
    void tellsOfARefusalAndOfALostConnection() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
        simulator.refusal = Optional.of("It is not to be.");
        open(simulator);
        Clicks.inSwing(() -> find("pause", AbstractButton.class).doClick(0));
        Clicks.inSwing(
                () -> {
                    JList<?> log = find("log", JList.class);
                    assertThat(log.getModel().getElementAt(0).toString())
                            .endsWith("It is not to be.");
                    assertThat(find("last-words", JLabel.class).getText())
                            .isEqualTo("It is not to be.");
                    assertThat(find("status", JLabel.class).isShowing()).isTrue();
                    assertThat(find("banner", JLabel.class).isVisible()).isFalse();
                });
        simulator.refusal = Optional.empty();
        Clicks.inSwing(() -> find("pause", AbstractButton.class).doClick(0));
        Clicks.inSwing(
                () -> {
                    window.orElseThrow().turn();
                    assertThat(find("last-words", JLabel.class).getText()).isBlank();
                    assertThat(find("status", JLabel.class).isShowing()).isTrue();
                });
        simulator.isConnected = false;
        Clicks.inSwing(
                () -> {
                    window.orElseThrow().turn();
                    assertThat(find("banner", JLabel.class).isVisible()).isTrue();
                    assertThat(find("banner", JLabel.class).getText()).contains("lost");
                    for (String words :
                            new String[] {
                                "status", "last-words", "rate-words", "simulator-words"
                            }) {
                        assertThat(find(words, JLabel.class).getText()).as(words).isBlank();
                    }
                    said(simulator, "The connection to 127.0.0.1:40001 is lost");
                    assertThat(find("last-words", JLabel.class).getText()).isBlank();
                    said(simulator, "The picture is saved.");
                    assertThat(find("last-words", JLabel.class).getText())
                            .isEqualTo("The picture is saved.");
                });
    }

    private void said(FakeSimulator simulator, String sentence) {
        simulator.scene().tell(new Occurrence(1, sentence));
        window.orElseThrow().turn();
    }

    @Test
    void restoresASnapshotAndDisconnectsAClientIfThatIsMeant() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
        open(simulator);
        Clicks.inSwing(() -> find("menu-simulator", JMenu.class).setSelected(true));
        Clicks.inSwing(() -> find("menu-simulator", JMenu.class).setSelected(false));
        onlyIfMeant(find("restore-before", AbstractButton.class), "Restore");
        onlyIfMeant(find("disconnect-4", AbstractButton.class), "Disconnect");
        assertThat(find("disconnect-3", AbstractButton.class).getText())
                .isEqualTo("Disconnect Viewer, admin at 127.0.0.1:6: this viewer...");
        assertThat(simulator.asked)
                .endsWith(
                        new ListClientsRequest(),
                        new RestoreSnapshotCommand("before"),
                        new DisconnectClientCommand("4", "an administrator has ended the session"));
    }

    @Test
    void resetsRemovesAndShutsDownOnlyIfThatIsMeant() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
        view.select(OptionalLong.of(9));
        open(simulator);
        onlyIfMeant(find("reset", AbstractButton.class), "Reset");
        onlyIfMeant(find("remove-entity", AbstractButton.class), "Remove");
        onlyIfMeant(find("shutdown", AbstractButton.class), "Shut down");
        assertThat(simulator.asked)
                .containsExactly(
                        new ResetCommand(),
                        new RemoveEntityCommand(9),
                        new ShutdownSimulatorCommand());
    }

    /** Chooses something twice: first it is not meant, then it is. */
    private static void onlyIfMeant(AbstractButton item, String deed) throws Exception {
        for (String answer : new String[] {"Cancel", deed}) {
            SwingUtilities.invokeLater(() -> item.doClick(0));
            Clicks.answer(answer);
        }
        Clicks.inSwing(() -> {});
    }

    @Test
    void plotsShowTheLastMinuteOfWhatIsSelectedOrSayWhyThereIsNone() throws Exception {
        Scene scene = Scenes.withBuoy();
        scene.add(
                SeenObject.of(
                        10,
                        WorldObjectDefinition.named("Rock").fixed().volume(new Sphere(1)).build()));
        open(new FakeSimulator(scene));
        Clicks.inSwing(
                () -> {
                    JLabel hint = find("plots-hint", JLabel.class);
                    assertThat(hint.isShowing()).isTrue();
                    assertThat(hint.getText()).startsWith("Select an object");
                    select(10);
                    assertThat(hint.getText()).isEqualTo("Rock is fixed: it does not move");
                    select(9);
                    assertThat(hint.getText()).isEqualTo("Buoy: no data yet");
                    scene.move(9, new Movement(1, Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO));
                    scene.move(9, new Movement(2, Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO));
                    scene.stepDone(2, 0);
                    scene.look(Long.MAX_VALUE / 2, look -> {});
                    select(10);
                    select(9);
                    assertThat(find("plots", JPanel.class).isShowing()).isTrue();
                    assertThat(hint.isShowing()).isFalse();
                });
    }

    private void select(long id) {
        view.select(OptionalLong.of(id));
        window.orElseThrow().turn();
    }

    @Test
    void aSmallWindowHasFewerPlots() throws Exception {
        open(new FakeSimulator(Scenes.withBuoy()));
        JPanel plots = find("plots", JPanel.class);
        ViewerWindow opened = window.orElseThrow();
        Clicks.inSwing(() -> assertThat(plots.getComponentCount()).isEqualTo(4));
        Clicks.inSwing(() -> opened.frame().setSize(opened.frame().getMinimumSize()));
        AtomicBoolean isSmall = new AtomicBoolean();
        while (!isSmall.get()) {
            Clicks.inSwing(() -> isSmall.set(plots.getComponentCount() < 4));
        }
    }

    @Test
    void readsAnEffectFromItsElement() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
        open(simulator);
        EffectDialog effects =
                new EffectDialog(
                        new Desk(simulator, camera, new FakeScreen(), view),
                        window.orElseThrow().frame());
        List<String> told = new ArrayList<>();
        Clicks.inSwing(
                () -> {
                    effects.add(9, "<gravity acceleration=\"5\"/>", told::add);
                    effects.add(9, "<levity/>", told::add);
                });
        Clicks.inSwing(() -> simulator.refusal = Optional.of("It is not to be."));
        Clicks.inSwing(() -> effects.add(9, "<gravity acceleration=\"6\"/>", told::add));
        Clicks.inSwing(() -> {});
        assertThat(told).hasSize(3).contains("Added.").endsWith("It is not to be.");
        assertThat(told).filteredOn(words -> words.contains("levity")).hasSize(1);
        assertThat(simulator.asked)
                .containsExactly(
                        new AddEffectCommand(9, new Gravity(5)),
                        new AddEffectCommand(9, new Gravity(6)));
    }

    @Test
    void whatHasLeftTheWorldIsSelectedNoMoreAndNothingIsDoneWithIt() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
        view.select(OptionalLong.of(9));
        open(simulator);
        Clicks.inSwing(
                () -> {
                    AbstractButton effect = find("add-effect", AbstractButton.class);
                    assertThat(effect.isEnabled()).isTrue();
                    simulator.scene().remove(9);
                    window.orElseThrow().turn();
                    assertThat(view.selected()).isEmpty();
                    assertThat(effect.isEnabled()).isFalse();
                    assertThat(effect.getToolTipText()).contains("Nothing is selected");
                });
    }

    @Test
    void theHelpHasAllKeysOfTheMenusAndIsClosed() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
        view.select(OptionalLong.of(9));
        open(simulator);
        for (String name : new String[] {"help-keys", "add-effect", "record-frames"}) {
            Clicks.inSwing(() -> find(name, AbstractButton.class).doClick(0));
            Clicks.answer("Close");
        }
        Clicks.inSwing(
                () -> {
                    assertThat(window.orElseThrow().frame().getOwnedWindows())
                            .filteredOn(Window::isShowing)
                            .isEmpty();
                    assertThat(accelerators()).hasSizeGreaterThan(20);
                    assertThat(helpedKeys()).containsAll(accelerators());
                });
    }

    /** The keys in the help's left cells above those that drive, and the letters of the layers. */
    private static List<String> helpedKeys() {
        String page = HelpMenu.keys().toLowerCase(Locale.ROOT);
        List<String> all = new ArrayList<>();
        String above = page.substring(0, page.indexOf("drives the selected"));
        Matcher cells = Pattern.compile("<td><b>(.+?)</b>").matcher(above);
        while (cells.find()) {
            all.addAll(List.of(cells.group(1).split(",? ", -1)));
        }
        Matcher layers = Pattern.compile("[:,] (.) ").matcher(page);
        while (layers.find()) {
            all.add("alt+shift+" + layers.group(1));
        }
        return all;
    }

    /** The accelerators, as the help names them. */
    private List<String> accelerators() {
        List<String> all = new ArrayList<>();
        JMenuBar bar = window.orElseThrow().frame().getJMenuBar();
        for (int menu = 0; menu < bar.getMenuCount(); menu++) {
            for (Component item : bar.getMenu(menu).getMenuComponents()) {
                if (item instanceof JMenuItem key && key.getAccelerator() != null) {
                    String words =
                            KeyEvent.getKeyText(key.getAccelerator().getKeyCode())
                                    .toLowerCase(Locale.ROOT);
                    int modifiers = key.getAccelerator().getModifiers();
                    if ((modifiers & InputEvent.ALT_DOWN_MASK) != 0) {
                        all.add("alt+shift+" + words);
                    } else if ((modifiers & InputEvent.SHIFT_DOWN_MASK) != 0) {
                        all.add("ctrl+shift+" + words);
                    } else if ((modifiers & InputEvent.CTRL_DOWN_MASK) != 0) {
                        all.add("ctrl+" + words);
                    } else if (!words.equals("f1")) {
                        all.add(words);
                    }
                }
            }
        }
        return all;
    }

    @Test
    void choosesViewAndColours() throws Exception {
        open(new FakeSimulator(Scenes.withBuoy()));
        Clicks.inSwing(
                () -> {
                    find("view-orthographic", AbstractButton.class).doClick(0);
                    find("view-top", AbstractButton.class).doClick(0);
                    find("show-ghosts-tool", AbstractButton.class).doClick(0);
                    find("show-trails", AbstractButton.class).doClick(0);
                    find("view-dark", AbstractButton.class).doClick(0);
                });
        assertThat(camera.isPerspective()).isFalse();
        assertThat(camera.forward(2)).isLessThan(-0.999);
        assertThat(view.shows(Layer.GHOSTS)).isFalse();
        assertThat(view.shows(Layer.TRAILS)).isFalse();
        assertThat(view.isDark()).isFalse();
    }

    private void open(Source source) throws Exception {
        Clicks.inSwing(
                () -> {
                    ViewerWindow opened =
                            new ViewerWindow(
                                    source,
                                    camera,
                                    new FakeScreen(),
                                    view,
                                    Optional::empty,
                                    () -> {});
                    window = Optional.of(opened);
                    assertThat(opened.show()).isDone();
                });
    }

    private <C extends Component> C find(String name, Class<C> kind) {
        return Clicks.find(window.orElseThrow(), name, kind);
    }
}
