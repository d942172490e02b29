package org.auvsim.viz.window;

import java.awt.BasicStroke;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Polygon;
import java.awt.RenderingHints;

import javax.swing.Icon;
import javax.swing.UIManager;

/** The signs on buttons, in the colour of the button's words. */
enum Signs implements Icon {
    /** A triangle. */
    PLAY {
        @Override
        void draw(Graphics2D g) {
            g.fill(triangle(4, 13));
        }
    },
    /** Two bars. */
    PAUSE {
        @Override
        void draw(Graphics2D g) {
            g.fillRect(4, 3, 3, 10);
            g.fillRect(9, 3, 3, 10);
        }
    },
    /** A triangle against a bar. */
    STEP {
        @Override
        void draw(Graphics2D g) {
            g.fill(triangle(3, 10));
            g.fillRect(11, 3, 2, 10);
        }
    },
    /** A bar against a triangle. */
    STEP_BACK {
        @Override
        void draw(Graphics2D g) {
            g.fill(triangle(13, 6));
            g.fillRect(3, 3, 2, 10);
        }
    },
    /** Four corners. */
    FIT {
        @Override
        void draw(Graphics2D g) {
            for (int i = 0; i < 4; i++) {
                g.drawLine(2, 2, 6, 2);
                g.drawLine(2, 2, 2, 6);
                g.rotate(Math.PI / 2, 8, 8);
            }
            g.fillRect(6, 6, 4, 4);
        }
    },
    /** A ring with a cross. */
    FOLLOW {
        @Override
        void draw(Graphics2D g) {
            g.drawOval(4, 4, 8, 8);
            for (int i = 0; i < 4; i++) {
                g.drawLine(8, 1, 8, 5);
                g.rotate(Math.PI / 2, 8, 8);
            }
        }
    },
    /** A steering wheel. */
    DRIVE {
        @Override
        void draw(Graphics2D g) {
            g.drawOval(2, 2, 12, 12);
            g.fillOval(6, 6, 4, 4);
            for (int i = 0; i < 3; i++) {
                g.drawLine(8, 8, 8, 14);
                g.rotate(2 * Math.PI / 3, 8, 8);
            }
        }
    },
    /** A camera. */
    PICTURE {
        @Override
        void draw(Graphics2D g) {
            g.drawRoundRect(1, 4, 13, 9, 3, 3);
            g.drawOval(5, 6, 5, 5);
            g.fillRect(5, 2, 5, 2);
        }
    },
    /** A ball. */
    RECORD {
        @Override
        void draw(Graphics2D g) {
            g.fillOval(3, 3, 10, 10);
        }
    };

    abstract void draw(Graphics2D g);

    private static Polygon triangle(int base, int tip) {
        return new Polygon(new int[] {base, base, tip}, new int[] {3, 13, 8}, 3);
    }

    @Override
    public void paintIcon(Component c, Graphics graphics, int x, int y) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.translate(x, y);
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setStroke(new BasicStroke(1.5f));
        g.setColor(
                c.isEnabled() ? c.getForeground() : UIManager.getColor("Label.disabledForeground"));
        draw(g);
        g.dispose();
    }

    @Override
    public int getIconWidth() {
        return 16;
    }

    @Override
    public int getIconHeight() {
        return 16;
    }
}
