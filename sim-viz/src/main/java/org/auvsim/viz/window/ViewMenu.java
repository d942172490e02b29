package org.auvsim.viz.window;

import org.auvsim.viz.camera.StandardView;
import org.auvsim.viz.drawing.Framing;
import org.auvsim.viz.drawing.Layer;

import java.util.Locale;
import java.util.OptionalLong;

import javax.swing.Action;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.KeyStroke;

/** From where is looked, and what is shown. */
final class ViewMenu {
    private final Desk desk;
    private final Runnable theme;
    private final Action fit;
    private final Action follow =
            new Act("Follow the selected object", this::followSelected).key("F");

    ViewMenu(Desk desk, Runnable theme) {
        this.desk = desk;
        this.theme = theme;
        fit = new Act("Fit all", () -> Framing.fit(desk.scene(), desk.camera())).key("0");
    }

    Action fit() {
        return fit;
    }

    Action follow() {
        return follow;
    }

    private void followSelected() {
        OptionalLong id = desk.options().selected();
        if (id.isPresent()) {
            desk.toggleFollow(id.getAsLong());
        } else {
            desk.say("Nothing is selected that could be followed.");
        }
    }

    JMenu menu() {
        JMenu menu = new JMenu("View");
        menu.setName("menu-view");
        menu.setMnemonic('V');
        look(menu, "From above", StandardView.TOP, "1");
        look(menu, "From the side, x to the right", StandardView.SIDE, "2");
        look(menu, "From ahead, against x", StandardView.FRONT, "3");
        look(menu, "From behind and above", StandardView.OBLIQUE, "4");
        menu.add(fit).setName("view-fit");
        menu.add(follow).setName("view-follow");
        menu.addSeparator();
        projection(menu);
        menu.addSeparator();
        for (Layer what : Layer.values()) {
            menu.add(toggle(what));
        }
        menu.addSeparator();
        menu.add(dark());
        return menu;
    }

    private void look(JMenu menu, String words, StandardView from, String key) {
        menu.add(new Act(words, () -> from.apply(desk.camera())).key(key))
                .setName("view-" + from.name().toLowerCase(Locale.ROOT));
    }

    private void projection(JMenu menu) {
        JMenuItem perspective = new JRadioButtonMenuItem("Perspective");
        JMenuItem orthographic = new JRadioButtonMenuItem("Orthographic");
        perspective.setName("view-perspective");
        orthographic.setName("view-orthographic");
        perspective.setAccelerator(KeyStroke.getKeyStroke("ctrl P"));
        orthographic.setAccelerator(KeyStroke.getKeyStroke("ctrl O"));
        perspective.addActionListener(e -> project(true));
        orthographic.addActionListener(e -> project(false));
        desk.onRefresh(
                () -> {
                    perspective.setSelected(desk.camera().isPerspective());
                    orthographic.setSelected(!desk.camera().isPerspective());
                });
        menu.add(perspective);
        menu.add(orthographic);
    }

    private void project(boolean inPerspective) {
        desk.camera().perspective(inPerspective);
        desk.refresh();
    }

    private JMenuItem toggle(Layer what) {
        JMenuItem item = new JCheckBoxMenuItem(what.title());
        item.setName("show-" + what.name().toLowerCase(Locale.ROOT));
        item.setAccelerator(KeyStroke.getKeyStroke("alt shift " + what.key()));
        item.addActionListener(
                e -> {
                    desk.options().show(what, !desk.options().shows(what));
                    desk.refresh();
                });
        desk.onRefresh(() -> item.setSelected(desk.options().shows(what)));
        return item;
    }

    private JMenuItem dark() {
        JMenuItem item = new JCheckBoxMenuItem("Dark colours");
        item.setName("view-dark");
        item.setAccelerator(KeyStroke.getKeyStroke("ctrl shift D"));
        item.addActionListener(
                e -> {
                    desk.options().dark(!desk.options().isDark());
                    theme.run();
                    desk.refresh();
                });
        desk.onRefresh(() -> item.setSelected(desk.options().isDark()));
        return item;
    }
}
