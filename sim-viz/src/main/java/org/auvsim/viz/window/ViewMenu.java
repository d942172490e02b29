package org.auvsim.viz.window;

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
        fit = new Act("Fit all", () -> Views.fit(desk.camera(), desk.scene())).key("0");
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
        menu.add(new Act("From above", () -> Views.top(desk.camera())).key("1"))
                .setName("view-top");
        menu.add(new Act("Side (against x)", () -> Views.side(desk.camera())).key("2"))
                .setName("view-side");
        menu.add(new Act("Front (along y)", () -> Views.front(desk.camera())).key("3"))
                .setName("view-front");
        menu.add(new Act("Isometric", () -> Views.isometric(desk.camera())).key("4"))
                .setName("view-isometric");
        menu.add(fit).setName("view-fit");
        menu.add(follow).setName("view-follow");
        menu.addSeparator();
        projection(menu);
        menu.addSeparator();
        for (Shown what : Shown.values()) {
            menu.add(toggle(what));
        }
        menu.addSeparator();
        menu.add(dark());
        return menu;
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

    private JMenuItem toggle(Shown what) {
        JMenuItem item = new JCheckBoxMenuItem(what.words());
        item.setName(what.componentName());
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
