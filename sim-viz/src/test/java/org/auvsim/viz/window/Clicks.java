package org.auvsim.viz.window;

import java.awt.Component;
import java.awt.Container;
import java.awt.Window;
import java.awt.event.MouseEvent;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;

import javax.swing.AbstractButton;
import javax.swing.JDialog;
import javax.swing.JMenu;
import javax.swing.SwingUtilities;

/** Uses windows as somebody at a desk does. */
final class Clicks {
    private Clicks() {}

    static void click(Component on, int x, int y) {
        for (int id :
                new int[] {
                    MouseEvent.MOUSE_PRESSED, MouseEvent.MOUSE_RELEASED, MouseEvent.MOUSE_CLICKED
                }) {
            on.dispatchEvent(new MouseEvent(on, id, 0, 0, x, y, 1, false, MouseEvent.BUTTON1));
        }
    }

    static <C extends Component> C find(ViewerWindow window, String name, Class<C> kind) {
        return find(window.frame(), name, kind);
    }

    static <C extends Component> C find(Container in, String name, Class<C> kind) {
        return find(in, name)
                .map(kind::cast)
                .orElseThrow(() -> new AssertionError("there is no component " + name));
    }

    private static Optional<Component> find(Container in, String name) {
        Component[] parts =
                in instanceof JMenu menu ? menu.getMenuComponents() : in.getComponents();
        for (Component part : parts) {
            if (name.equals(part.getName())) {
                return Optional.of(part);
            }
            Optional<Component> inside =
                    part instanceof Container more ? find(more, name) : Optional.empty();
            if (inside.isPresent()) {
                return inside;
            }
        }
        return Optional.empty();
    }

    /** Answers the question that comes, by the words on a button. */
    static void answer(String words) throws Exception {
        AtomicBoolean isAnswered = new AtomicBoolean();
        while (!isAnswered.get()) {
            inSwing(
                    () ->
                            Stream.of(Window.getWindows())
                                    .filter(Window::isShowing)
                                    .filter(JDialog.class::isInstance)
                                    .flatMap(dialog -> button(dialog, words).stream())
                                    .findFirst()
                                    .ifPresent(
                                            button -> {
                                                isAnswered.set(true);
                                                button.doClick(0);
                                            }));
        }
    }

    private static Optional<AbstractButton> button(Container in, String words) {
        for (Component part : in.getComponents()) {
            if (part instanceof AbstractButton button && words.equals(button.getText())) {
                return Optional.of(button);
            }
            Optional<AbstractButton> inside =
                    part instanceof Container more ? button(more, words) : Optional.empty();
            if (inside.isPresent()) {
                return inside;
            }
        }
        return Optional.empty();
    }

    /** Does something on the Swing thread; what fails there fails here. */
    static void inSwing(Runnable deed) throws Exception {
        AtomicReference<Throwable> failure = new AtomicReference<>();
        SwingUtilities.invokeAndWait(
                () -> {
                    try {
                        deed.run();
                    } catch (RuntimeException | AssertionError e) {
                        failure.set(e);
                    }
                });
        if (failure.get() != null) {
            throw new AssertionError(failure.get());
        }
    }
}
