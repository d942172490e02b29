package org.auvsim.viz.jme;

import com.jme3.font.BitmapFont;
import com.jme3.material.Material;
import com.jme3.material.RenderState.BlendMode;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial.CullHint;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * Words on the picture. To lay out a label is dear, so those of frames before are used again where
 * their words are the same.
 */
final class Labels {
    /** So many labels are kept, seen or not. */
    private static final int KEPT = 64;

    private final BitmapFont font;
    private final Material plate;
    private final Node node = new Node("labels");

    /** Those of this frame first. */
    private final List<Label> texts = new ArrayList<>();

    private int used;

    /** Of the letters of a font, on plates of a material. */
    Labels(BitmapFont font, Material plate) {
        this.font = font;
        this.plate = plate;
        plate.getAdditionalRenderState().setBlendMode(BlendMode.Alpha);
    }

    Node node() {
        return node;
    }

    void begin() {
        used = 0;
    }

    /**
     * Words whose middle stands at a pixel, counted from the left and from the bottom, in a picture
     * of so many pixels.
     */
    void add(double x, double y, String words, int colour, int width, int height) {
        Label text = next(words);
        if (!text.words().equals(words)) {
            text.write(words);
        }
        text.colour(colour);
        text.stand(x, y, width, height);
        text.node().setCullHint(CullHint.Never);
    }

    /** One that has these words already, if there is one. */
    private Label next(String words) {
        for (int i = used; i < texts.size(); i++) {
            if (texts.get(i).words().equals(words)) {
                return take(i);
            }
        }
        if (used == texts.size() || texts.size() < KEPT) {
            Label text = new Label(font, plate);
            texts.add(text);
            node.attachChild(text.node());
        }
        return take(texts.size() - 1);
    }

    private Label take(int i) {
        Collections.swap(texts, i, used);
        return texts.get(used++);
    }

    void end() {
        for (int i = used; i < texts.size(); i++) {
            texts.get(i).node().setCullHint(CullHint.Always);
        }
    }
}
