package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.viz.scene.LiveClock;
import org.auvsim.viz.scene.Movement;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.knowm.xchart.XChartPanel;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;

import javax.swing.JComponent;
import javax.swing.JLabel;

/** Needs a display for the component that paints charts. */
@Tag("display")
class PlotTest {
    private static final int WIDTH = 320;
    private static final int HEIGHT = 170;

    private Plot plot = new Plot("m", Quantity.X, Quantity.Y);

    private Component part(String where) {
        BorderLayout layout = (BorderLayout) plot.component().getLayout();
        return layout.getLayoutComponent(where);
    }

    /** X falls from the upper left to the lower right while y rises; it dives meanwhile. */
    private BufferedImage picture() throws Exception {
        Scene scene = new Scene(new LiveClock());
        scene.add(SeenObject.of(9, Scenes.buoy()));
        for (int t = 0; t <= 50; t++) {
            Vec3 place = new Vec3(50 - t, t, -t);
            scene.move(9, new Movement(t, place, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO));
        }
        scene.jumpTo(50);
        scene.look(0, look -> {});
        BufferedImage picture = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Clicks.inSwing(
                () -> {
                    JComponent component = plot.component();
                    plot.colour();
                    plot.draw(scene.lookAt(9, a -> History.of(a, 50)).orElseThrow());
                    component.setSize(WIDTH, HEIGHT);
                    component.doLayout();
                    Graphics2D graphics = picture.createGraphics();
                    component.paint(graphics);
                    graphics.dispose();
                });
        return picture;
    }

    @Test
    void theTitleNamesEachLineInItsColour() {
        assertThat(((JLabel) part(BorderLayout.NORTH)).getText())
                .isEqualTo(
                        "<html><font color='#e5734f'>x</font>,"
                                + " <font color='#5bb974'>y</font> (m)");
    }

    @Test
    void nothingLiesOverTheLines() throws Exception {
        BufferedImage picture = picture();
        Component lines = part(BorderLayout.CENTER);
        assertThat(((XChartPanel<?>) lines).getChart().getStyler().isLegendVisible()).isFalse();
        Rectangle title = part(BorderLayout.NORTH).getBounds();
        assertThat(title.intersects(lines.getBounds())).isFalse();
        // Both lines can be followed through the whole plot, a tenth of its width at a time.
        for (Quantity quantity : new Quantity[] {Quantity.X, Quantity.Y}) {
            int rgb = quantity.colour().getRGB();
            int first = column(picture, lines.getBounds(), rgb, 1);
            int last = column(picture, lines.getBounds(), rgb, -1);
            assertThat(last - first).isGreaterThan(WIDTH / 2);
            for (int from = first; from + WIDTH / 10 < last; from += WIDTH / 10) {
                Rectangle strip = new Rectangle(from, lines.getY(), WIDTH / 10, lines.getHeight());
                assertThat(column(picture, strip, rgb, 1)).isNotNegative();
            }
        }
    }

    @Test
    void whatIsDeeperStandsLower() throws Exception {
        plot = new Plot("m", Quantity.DEPTH);
        BufferedImage picture = picture();
        Rectangle lines = part(BorderLayout.CENTER).getBounds();
        int rgb = Quantity.DEPTH.colour().getRGB();
        int first = column(picture, lines, rgb, 1);
        int last = column(picture, lines, rgb, -1);
        assertThat(row(picture, last, rgb)).isGreaterThan(row(picture, first, rgb) + HEIGHT / 4);
    }

    /** The first row from the top that has a colour in a column. */
    private static int row(BufferedImage picture, int x, int rgb) {
        int y = 0;
        while (picture.getRGB(x, y) != rgb) {
            y++;
        }
        return y;
    }

    /** The first column, from the left (1) or the right (-1), that has a colour; -1 if none has. */
    private static int column(BufferedImage picture, Rectangle in, int rgb, int step) {
        int begin = step > 0 ? in.x : in.x + in.width - 1;
        for (int x = begin; x >= in.x && x < in.x + in.width; x += step) {
            for (int y = in.y; y < in.y + in.height; y++) {
                if (picture.getRGB(x, y) == rgb) {
                    return x;
                }
            }
        }
        return -1;
    }
}
