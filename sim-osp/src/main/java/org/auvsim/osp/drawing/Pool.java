// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp.drawing;

import org.opensourcephysics.display3d.simple3d.DrawingPanel3D;
import org.opensourcephysics.display3d.simple3d.Element;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/** Elements that are used again from frame to frame; those not used are not seen. */
final class Pool<E extends Element> {
    private final List<E> elements = new ArrayList<>();
    private final DrawingPanel3D panel;
    private final Supplier<E> maker;
    private int used;

    Pool(DrawingPanel3D panel, Supplier<E> maker) {
        this.panel = panel;
        this.maker = maker;
    }

    void begin() {
        used = 0;
    }

    E next() {
        if (used == elements.size()) {
            E made = maker.get();
            elements.add(made);
            panel.addElement(made);
        }
        E element = elements.get(used++);
        element.setVisible(true);
        return element;
    }

    void end() {
        for (int i = used; i < elements.size(); i++) {
            elements.get(i).setVisible(false);
        }
    }
}
