package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.drawing.ViewOptions;
import org.auvsim.viz.source.Source;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;

import java.awt.Component;
import java.util.Optional;
import java.util.OptionalLong;

import javax.swing.AbstractButton;
import javax.swing.JFrame;
import javax.swing.JTabbedPane;

/** The window of a test, whose screen is a fake; closed after it. */
final class OpenedWindow implements AfterEachCallback {
    private final OrbitCamera camera = new OrbitCamera();
    private final ViewOptions view = new ViewOptions();
    private Optional<ViewerWindow> window = Optional.empty();

    OrbitCamera camera() {
        return camera;
    }

    ViewOptions view() {
        return view;
    }

    JFrame frame() {
        return window.orElseThrow().frame();
    }

    void open(Source source) throws Exception {
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

    /** With this object selected, and the tab beside the picture that steers it in front. */
    void openAtControl(Source source, long id) throws Exception {
        view.select(OptionalLong.of(id));
        open(source);
        Clicks.inSwing(() -> find("right", JTabbedPane.class).setSelectedIndex(1));
    }

    <C extends Component> C find(String name, Class<C> kind) {
        return Clicks.find(window.orElseThrow(), name, kind);
    }

    AbstractButton button(String name) {
        return find(name, AbstractButton.class);
    }

    /** Presses buttons and chooses items, by their names. */
    void click(String... names) throws Exception {
        Clicks.inSwing(
                () -> {
                    for (String name : names) {
                        button(name).doClick(0);
                    }
                });
    }

    /** Selects an object, and shows that; of the Swing thread alone. */
    void select(long id) {
        view.select(OptionalLong.of(id));
        turn();
    }

    /** Brings up to date what is seen; of the Swing thread alone. */
    void turn() {
        window.orElseThrow().turn();
    }

    @Override
    public void afterEach(ExtensionContext context) throws Exception {
        Clicks.inSwing(() -> window.ifPresent(ViewerWindow::close));
    }
}
