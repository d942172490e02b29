package org.auvsim.viz.window;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;

import javax.swing.JPopupMenu;
import javax.swing.ToolTipManager;
import javax.swing.UIManager;

/** The colours of windows. */
final class Theme {
    private Theme() {}

    /** Makes all windows dark or light; of the Swing thread. */
    static void set(boolean dark) {
        // The picture is a component of the system's: menus must be, too, to be seen above it.
        JPopupMenu.setDefaultLightWeightPopupEnabled(false);
        ToolTipManager.sharedInstance().setLightWeightPopupEnabled(false);
        // A click beside a slider's knob brings it there.
        UIManager.put("Slider.scrollOnTrackClick", false);
        // Beside its name a column's head has no room for the arrow of its order.
        UIManager.put("TableHeader.sortIconPosition", "top");
        if (dark) {
            FlatDarkLaf.setup();
        } else {
            FlatLightLaf.setup();
        }
        FlatLaf.updateUI();
    }
}
