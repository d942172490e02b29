package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.message.control.ResetCommand;
import org.auvsim.auvsml.message.control.RestoreSnapshotCommand;
import org.auvsim.auvsml.message.control.ShutdownSimulatorCommand;
import org.auvsim.auvsml.message.entity.AddEffectCommand;
import org.auvsim.auvsml.message.entity.RemoveEntityCommand;
import org.auvsim.auvsml.message.session.DisconnectClientCommand;
import org.auvsim.auvsml.message.session.ListClientsRequest;
import org.auvsim.core.effect.Gravity;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

import java.awt.Component;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import javax.swing.AbstractButton;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.SwingUtilities;

/** Somebody goes through the menus; needs a display. */
@Tag("display")
class MenusTest {
    @RegisterExtension private final OpenedWindow window = new OpenedWindow();
    private final FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());

    private void openAtBuoy() throws Exception {
        window.view().select(OptionalLong.of(9));
        window.open(simulator);
    }

    @Test
    void restoresASnapshotAndDisconnectsAClientIfThatIsMeant() throws Exception {
        window.open(simulator);
        Clicks.inSwing(() -> window.find("menu-simulator", JMenu.class).setSelected(true));
        Clicks.inSwing(() -> window.find("menu-simulator", JMenu.class).setSelected(false));
        onlyIfMeant("restore-before", "Restore");
        onlyIfMeant("disconnect-4", "Disconnect");
        assertThat(window.button("disconnect-3").getText())
                .isEqualTo("Disconnect Viewer, admin at 127.0.0.1:6: this viewer...");
        assertThat(simulator.asked)
                .endsWith(
                        new ListClientsRequest(),
                        new RestoreSnapshotCommand("before"),
                        new DisconnectClientCommand("4", "an administrator has ended the session"));
    }

    @Test
    void resetsRemovesAndShutsDownOnlyIfThatIsMeant() throws Exception {
        openAtBuoy();
        onlyIfMeant("reset", "Reset");
        onlyIfMeant("remove-entity", "Remove");
        onlyIfMeant("shutdown", "Shut down");
        assertThat(simulator.asked)
                .containsExactly(
                        new ResetCommand(),
                        new RemoveEntityCommand(9),
                        new ShutdownSimulatorCommand());
    }

    /** Chooses something twice: first it is not meant, then it is. */
    private void onlyIfMeant(String name, String deed) throws Exception {
        AbstractButton item = window.button(name);
        for (String answer : new String[] {"Cancel", deed}) {
            SwingUtilities.invokeLater(() -> item.doClick(0));
            Clicks.answer(answer);
        }
        Clicks.inSwing(() -> {});
    }

    @Test
    void readsAnEffectFromItsElement() throws Exception {
        window.open(simulator);
        EffectDialog effects =
                new EffectDialog(
                        new Desk(simulator, window.camera(), new FakeScreen(), window.view()),
                        window.frame());
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
    void theHelpHasAllKeysOfTheMenusAndIsClosed() throws Exception {
        openAtBuoy();
        for (String name : new String[] {"help-keys", "add-effect", "record-frames"}) {
            window.click(name);
            Clicks.answer("Close");
        }
        Clicks.inSwing(
                () -> {
                    assertThat(window.frame().getOwnedWindows())
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
        JMenuBar bar = window.frame().getJMenuBar();
        for (int menu = 0; menu < bar.getMenuCount(); menu++) {
            for (Component item : bar.getMenu(menu).getMenuComponents()) {
                if (item instanceof JMenuItem key && key.getAccelerator() != null) {
                    String stroke = key.getAccelerator().toString();
                    String words =
                            stroke.substring(stroke.lastIndexOf(' ') + 1).toLowerCase(Locale.ROOT);
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
}
