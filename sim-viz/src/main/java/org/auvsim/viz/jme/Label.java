package org.auvsim.viz.jme;

import com.jme3.font.BitmapFont;
import com.jme3.font.BitmapText;
import com.jme3.material.Material;
import com.jme3.math.ColorRGBA;
import com.jme3.scene.Geometry;
import com.jme3.scene.Node;
import com.jme3.scene.shape.Quad;

/**
 * Words; behind light ones a dark plate that lets the picture through, behind dark ones a light
 * one, and none behind colours.
 */
final class Label {
    /** How high letters are (pixels). */
    static final float SIZE = 15;

    /** The plate is wider than its words by this on either side (pixels). */
    private static final float MARGIN = 3;

    private static final float PLATE = 0.55f;

    private final Node node = new Node("label");
    private final BitmapText text;
    private final Geometry plate;
    private final ColorRGBA shade = new ColorRGBA();
    private final ColorRGBA back = new ColorRGBA();

    Label(BitmapFont font, Material material) {
        text = new BitmapText(font);
        text.setSize(SIZE);
        text.setLocalTranslation(0, 0, 1);
        plate = new Geometry("plate", new Quad(1, 1));
        plate.setMaterial(material.clone());
        node.attachChild(plate);
        node.attachChild(text);
    }

    Node node() {
        return node;
    }

    String words() {
        return text.getText();
    }

    void write(String words) {
        text.setText(words);
        plate.setLocalTranslation(-MARGIN, -text.getLineHeight(), 0);
        plate.setLocalScale(text.getLineWidth() + 2 * MARGIN, text.getLineHeight(), 1);
    }

    /** Words of this colour, 0xRRGGBB. */
    void colour(int colour) {
        shade.set(
                (colour >> 16 & 0xff) / 255f,
                (colour >> 8 & 0xff) / 255f,
                (colour & 0xff) / 255f,
                1);
        if (!shade.equals(text.getColor())) {
            text.setColor(shade.clone());
            float grey = shade.g > 0.5f ? 0.05f : 1;
            boolean isGrey = Math.abs(shade.r - shade.g) + Math.abs(shade.g - shade.b) < 0.2f;
            back.set(grey, grey, grey, isGrey ? PLATE : 0);
            plate.getMaterial().setColor("Color", back);
        }
    }

    /** Its middle stands at a pixel from the left and its foot on one from the bottom. */
    void stand(double x, double y, int width, int height) {
        float wide = text.getLineWidth();
        float high = text.getLineHeight();
        // Where it would stick out of the picture it stands at the edge.
        double left = Math.clamp(x - wide / 2, MARGIN, Math.max(MARGIN, width - wide - MARGIN));
        double top = Math.clamp(y + SIZE, high, Math.max(high, height));
        node.setLocalTranslation((float) Math.rint(left), (float) Math.rint(top), 0);
    }
}
