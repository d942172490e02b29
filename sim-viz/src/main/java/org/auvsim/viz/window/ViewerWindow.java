package org.auvsim.viz.window;

import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.drawing.Screen;
import org.auvsim.viz.drawing.ViewOptions;
import org.auvsim.viz.driving.Gamepad;
import org.auvsim.viz.source.Source;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.KeyboardFocusManager;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.concurrent.CompletableFuture;

import javax.swing.JFrame;
import javax.swing.JMenuBar;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.Timer;
import javax.swing.WindowConstants;

/** The window around a picture. Make and use it on the Swing thread. */
public final class ViewerWindow {
    /** Lists and words are brought up to date so often (ms). */
    private static final int REFRESH = 100;

    /** What is below the picture is so high at first (pixels). */
    private static final int BELOW = 200;

    private final Desk desk;
    private final JFrame frame;
    private final Recorder recorder;
    private final Driver driver;
    private final Plots plots;
    private final Runnable onClose;
    private final Timer refresh = new Timer(REFRESH, e -> turn());
    private JSplitPane centre = new JSplitPane();
    private boolean isClosed;

    /**
     * A window, not yet seen.
     *
     * @param onClose is called once it has been closed; source and screen are then the caller's to
     *     close
     */
    public ViewerWindow(
            Source source,
            OrbitCamera camera,
            Screen screen,
            ViewOptions options,
            Gamepad gamepad,
            Runnable onClose) {
        Theme.set(options.isDark());
        desk = new Desk(source, camera, screen, options);
        this.onClose = onClose;
        frame = new JFrame("auvsim viewer");
        recorder = new Recorder(screen);
        driver = new Driver(desk, gamepad, frame);
        plots = new Plots(desk);
        build();
        frame.setMinimumSize(new Dimension(840, 560));
        frame.setSize(1280, 800);
        frame.setLocationByPlatform(true);
        frame.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
        frame.addWindowListener(
                new WindowAdapter() {
                    @Override
                    public void windowClosing(WindowEvent e) {
                        close();
                    }
                });
    }

    private void build() {
        FileMenu file = new FileMenu(desk, frame, recorder, this::close);
        ViewMenu view = new ViewMenu(desk, this::colour);
        ObjectMenu object = new ObjectMenu(desk, frame);
        JMenuBar menus = new JMenuBar();
        menus.add(file.menu());
        menus.add(view.menu());
        menus.add(object.menu());
        JPanel bottom = new JPanel(new BorderLayout());
        desk.source()
                .playback()
                .ifPresent(
                        p -> {
                            PlaybackBar bar = new PlaybackBar(desk, p);
                            menus.add(bar.menu(desk));
                            bottom.add(bar.component(), BorderLayout.NORTH);
                        });
        desk.source()
                .steering()
                .ifPresent(
                        s -> {
                            SimulatorBar bar = new SimulatorBar(desk, s);
                            menus.add(new SimulatorMenu(desk, frame).menu(bar));
                            bottom.add(bar.component(), BorderLayout.CENTER);
                        });
        menus.add(HelpMenu.menu(frame));
        bottom.add(new StatusBar(desk).component(), BorderLayout.SOUTH);
        Tools tools =
                new Tools(desk)
                        .add(view.fit(), Signs.FIT, "fit-tool", "Fit all (0)")
                        .add(view.follow(), Signs.FOLLOW, "follow-tool", "Follow (F)")
                        .add(object.drive(), Signs.DRIVE, "drive-tool", "Drive (Ctrl+D)")
                        .add(file.save(), Signs.PICTURE, "save-tool", "Save picture (Ctrl+S)")
                        .add(file.record(), Signs.RECORD, "record-tool", "Record frames")
                        .gap()
                        .toggles();
        JPanel top = new JPanel(new BorderLayout());
        top.add(tools.component(), BorderLayout.NORTH);
        top.add(new Banner(desk).component(), BorderLayout.SOUTH);
        frame.setJMenuBar(menus);
        frame.add(top, BorderLayout.NORTH);
        frame.add(middle(), BorderLayout.CENTER);
        frame.add(bottom, BorderLayout.SOUTH);
    }

    private JSplitPane middle() {
        Component picture = desk.screen().component();
        picture.setMinimumSize(new Dimension(180, 100));
        ScreenMouse.attach(desk);
        JTabbedPane below = new JTabbedPane();
        below.setName("below");
        below.addTab("Plots", plots.component());
        below.addTab("Log", new WordsLog(desk).component());
        below.setMinimumSize(new Dimension(180, 140));
        below.setPreferredSize(new Dimension(600, BELOW));
        JTabbedPane right = new JTabbedPane();
        right.setName("right");
        right.addTab("Details", new Details(desk).component());
        right.addTab("Control", new ControlPanel(desk).component());
        right.setMinimumSize(new Dimension(180, 100));
        right.setPreferredSize(new Dimension(356, 500));
        centre = split(JSplitPane.VERTICAL_SPLIT, picture, below, 1);
        JSplitPane withRight = split(JSplitPane.HORIZONTAL_SPLIT, centre, right, 1);
        JPanel left = new ObjectList(desk).component();
        left.setMinimumSize(new Dimension(140, 100));
        left.setPreferredSize(new Dimension(292, 500));
        return split(JSplitPane.HORIZONTAL_SPLIT, left, withRight, 0);
    }

    private static JSplitPane split(int how, Component one, Component other, double share) {
        JSplitPane pane = new JSplitPane(how, true, one, other);
        pane.setResizeWeight(share);
        pane.setBorder(null);
        return pane;
    }

    /**
     * Shows it, and lets the screen paint.
     *
     * @return done with the first frame; fails as {@link Screen#start} does
     */
    public CompletableFuture<Void> show() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(driver);
        frame.setVisible(true);
        centre.setDividerLocation(Math.max(0, centre.getHeight() - BELOW));
        CompletableFuture<Void> started = desk.screen().start();
        desk.screen().component().requestFocusInWindow();
        desk.refresh();
        refresh.start();
        return started;
    }

    /** The frame, for who wants to place it. */
    public JFrame frame() {
        return frame;
    }

    /** Closes it. */
    public void close() {
        if (isClosed) {
            return;
        }
        isClosed = true;
        refresh.stop();
        desk.drive(false);
        driver.turn();
        KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(driver);
        recorder.close();
        frame.dispose();
        onClose.run();
    }

    private void colour() {
        Theme.set(desk.options().isDark());
        plots.colour();
    }

    /** Brings all parts up to date, and sends what waits. */
    void turn() {
        driver.turn();
        desk.source().steering().ifPresent(s -> s.watch(desk.options().selected()));
        desk.outbox().send();
        desk.refresh();
    }
}
