package org.auvsim.viz.window;

import org.auvsim.viz.scene.Movement;

import java.awt.Component;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.OptionalLong;

import javax.swing.SwingUtilities;

/** What the mouse does in the picture: orbit, pan, zoom, select and centre. */
final class ScreenMouse extends MouseAdapter {
    /** A pixel turns the camera by this (rad). */
    private static final double TURN = Math.toRadians(0.4);

    /** A notch of the wheel brings the camera so much nearer. */
    private static final double ZOOM = 1.15;

    private final Desk desk;
    private final Component screen;
    private int x;
    private int y;

    private ScreenMouse(Desk desk) {
        this.desk = desk;
        screen = desk.screen().component();
    }

    static void attach(Desk desk) {
        ScreenMouse mouse = new ScreenMouse(desk);
        mouse.screen.addMouseListener(mouse);
        mouse.screen.addMouseMotionListener(mouse);
        mouse.screen.addMouseWheelListener(mouse);
        // A component of the system's has no key bindings; those of the menus are asked here.
        mouse.screen.addKeyListener(
                new KeyAdapter() {
                    @Override
                    public void keyPressed(KeyEvent e) {
                        if (SwingUtilities.processKeyBindings(e)) {
                            e.consume();
                        }
                    }
                });
    }

    @Override
    public void mousePressed(MouseEvent e) {
        x = e.getX();
        y = e.getY();
        screen.requestFocusInWindow();
    }

    @Override
    public void mouseDragged(MouseEvent e) {
        int right = e.getX() - x;
        int down = e.getY() - y;
        x = e.getX();
        y = e.getY();
        boolean isLeft = SwingUtilities.isLeftMouseButton(e);
        if (SwingUtilities.isMiddleMouseButton(e) || (isLeft && e.isShiftDown())) {
            desk.options().follow(OptionalLong.empty());
            double height = Math.max(1, screen.getHeight());
            desk.camera().pan(-right / height, down / height);
        } else if (isLeft) {
            desk.camera().orbit(-right * TURN, down * TURN);
        }
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent e) {
        desk.camera().zoom(Math.pow(ZOOM, e.getPreciseWheelRotation()));
    }

    @Override
    public void mouseClicked(MouseEvent e) {
        if (!SwingUtilities.isLeftMouseButton(e)) {
            return;
        }
        OptionalLong id =
                Picking.at(
                        desk.scene(),
                        desk.camera(),
                        e.getX(),
                        e.getY(),
                        screen.getWidth(),
                        screen.getHeight());
        if (e.getClickCount() == 1) {
            desk.select(id);
        } else if (id.isPresent()) {
            desk.scene()
                    .motion(id.getAsLong())
                    .map(Movement::position)
                    .ifPresent(p -> desk.camera().lookAt(p.x(), p.y(), p.z()));
        }
    }
}
