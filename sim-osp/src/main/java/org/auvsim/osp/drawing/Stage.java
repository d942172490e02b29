// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp.drawing;

import org.opensourcephysics.display3d.core.ElementText;
import org.opensourcephysics.display3d.core.Style;
import org.opensourcephysics.display3d.simple3d.DrawingPanel3D;
import org.opensourcephysics.display3d.simple3d.ElementSegment;

import java.awt.Color;
import java.awt.Font;
import java.util.HashMap;
import java.util.Map;

/**
 * The elements of a frame. Their numbers say in what order they are painted, whatever their depth;
 * elements of one number are painted by depth.
 */
final class Stage {
    /** The depths of a number are all larger than those of the next. */
    private static final double STEP = 1e8;

    /** There may be so many numbers: then factors are still finite. */
    static final int MOST = 60;

    private static final int LETTERS = 13;

    private final Pool<Tiles> tiles;
    private final Pool<ElementSegment> segments;
    private final Pool<org.opensourcephysics.display3d.simple3d.ElementText> texts;
    private final Map<Long, Tiles> byNumberAndColour = new HashMap<>();
    private final Map<Integer, Color> colours = new HashMap<>();
    private final int scale;

    Stage(DrawingPanel3D panel, int scale) {
        this.scale = scale;
        tiles = new Pool<>(panel, Tiles::new);
        segments = new Pool<>(panel, this::segment);
        texts = new Pool<>(panel, this::text);
    }

    private ElementSegment segment() {
        ElementSegment segment = new ElementSegment();
        segment.getStyle().setLineWidth(scale);
        return segment;
    }

    private org.opensourcephysics.display3d.simple3d.ElementText text() {
        var text = new org.opensourcephysics.display3d.simple3d.ElementText();
        text.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, scale * LETTERS));
        text.setJustification(ElementText.JUSTIFICATION_CENTER);
        text.getStyle().setDepthFactor(factor(MOST + 1));
        return text;
    }

    void begin() {
        tiles.begin();
        segments.begin();
        texts.begin();
        byNumberAndColour.clear();
    }

    void end() {
        tiles.end();
        segments.end();
        texts.end();
    }

    private static double factor(int number) {
        return Math.pow(STEP, MOST / 2 - number);
    }

    private Color colour(int argb) {
        return colours.computeIfAbsent(argb, c -> new Color(c, true));
    }

    /** Shows a face or a line. */
    void show(Face face, int number) {
        if (face.corners().length == 2) {
            line(face, number);
        } else if (face.corners().length > 2) {
            long key = (long) number << Integer.SIZE | (face.colour() & 0xffffffffL);
            byNumberAndColour
                    .computeIfAbsent(key, _ -> tiles(number, face.colour()))
                    .add(face.corners());
        }
    }

    private Tiles tiles(int number, int colour) {
        Tiles next = tiles.next();
        next.clear();
        next.getStyle().setDepthFactor(factor(number));
        next.getStyle().setFillColor(colour(colour));
        return next;
    }

    private void line(Face line, int number) {
        double[] a = line.corners()[0];
        double[] b = line.corners()[1];
        ElementSegment segment = segments.next();
        segment.setXYZ(a[0], a[1], a[2]);
        segment.setSizeXYZ(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
        Style style = segment.getStyle();
        style.setDepthFactor(line.farther() * factor(number));
        style.setLineColor(colour(line.colour()));
    }

    /** How high letters are (pixels). */
    int letters() {
        return scale * LETTERS;
    }

    /** Words before everything else. */
    void words(double[] at, String words, int colour) {
        var text = texts.next();
        text.setXYZ(at[0], at[1], at[2]);
        if (!words.equals(text.getText())) {
            text.setText(words);
        }
        text.getStyle().setLineColor(colour(colour));
    }
}
