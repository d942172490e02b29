package org.auvsim.viz.jme;

import com.jme3.font.BitmapFont;
import com.jme3.font.BitmapText;
import com.jme3.math.ColorRGBA;
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
    /** How high letters are (pixels). */
    static final float SIZE = 15;

    /** So many labels are kept, seen or not. */
    private static final int KEPT = 64;

    private final BitmapFont font;
    private final Node node = new Node("labels");

    /** Those of this frame first. */
    private final List<BitmapText> texts = new ArrayList<>();

    private final ColorRGBA shade = new ColorRGBA();
    private int used;

    Labels(BitmapFont font) {
        this.font = font;
    }

    Node node() {
        return node;
    }

    void begin() {
        used = 0;
    }

    /** Words whose middle stands at a pixel, counted from the left and from the bottom. */
    void add(double x, double y, String words, int colour) {
        BitmapText text = next(words);
        if (!text.getText().equals(words)) {
            text.setText(words);
        }
        shade.set(
                (colour >> 16 & 0xff) / 255f,
                (colour >> 8 & 0xff) / 255f,
                (colour & 0xff) / 255f,
                1);
        if (!shade.equals(text.getColor())) {
            text.setColor(shade.clone());
        }
        text.setLocalTranslation(
                (float) Math.rint(x - text.getLineWidth() / 2), (float) Math.rint(y + SIZE), 0);
        text.setCullHint(CullHint.Never);
    }

    /** One that has these words already, if there is one. */
    private BitmapText next(String words) {
        for (int i = used; i < texts.size(); i++) {
            if (texts.get(i).getText().equals(words)) {
                return take(i);
            }
        }
        if (used == texts.size() || texts.size() < KEPT) {
            BitmapText text = new BitmapText(font);
            text.setSize(SIZE);
            texts.add(text);
            node.attachChild(text);
        }
        return take(texts.size() - 1);
    }

    private BitmapText take(int i) {
        Collections.swap(texts, i, used);
        return texts.get(used++);
    }

    void end() {
        for (int i = used; i < texts.size(); i++) {
            texts.get(i).setCullHint(CullHint.Always);
        }
    }
}
