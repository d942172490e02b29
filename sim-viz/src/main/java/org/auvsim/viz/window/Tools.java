package org.auvsim.viz.window;

import org.auvsim.viz.drawing.Layer;

import java.util.Locale;

import javax.swing.Action;
import javax.swing.JButton;
import javax.swing.JToggleButton;
import javax.swing.JToolBar;

/** The buttons above the picture. */
final class Tools {
    private final Desk desk;
    private final JToolBar bar = new JToolBar();

    Tools(Desk desk) {
        this.desk = desk;
        bar.setName("tools");
        bar.setFloatable(false);
    }

    JToolBar component() {
        return bar;
    }

    Tools add(Action action, Signs sign, String name, String tip) {
        JButton button = new JButton(action);
        button.setHideActionText(true);
        button.setText(null);
        button.setIcon(sign);
        button.setName(name);
        button.setToolTipText(tip);
        button.setFocusable(false);
        bar.add(button);
        return this;
    }

    Tools gap() {
        bar.addSeparator();
        return this;
    }

    /** A button with a word for each thing that may be shown. */
    Tools toggles() {
        for (Layer what : Layer.values()) {
            JToggleButton button = new JToggleButton(what.word());
            button.setName("show-" + what.name().toLowerCase(Locale.ROOT) + "-tool");
            button.setToolTipText(what.title());
            button.setFocusable(false);
            button.addActionListener(
                    e -> {
                        desk.options().show(what, button.isSelected());
                        desk.refresh();
                    });
            desk.onRefresh(() -> button.setSelected(desk.options().shows(what)));
            bar.add(button);
        }
        return this;
    }
}
