// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp.drawing;

import java.awt.image.BufferedImage;

/** Makes pictures smaller: a pixel becomes the mean of a square. */
final class Shrinking {
    private Shrinking() {}

    static BufferedImage by(int factor, BufferedImage large) {
        int width = large.getWidth() / factor;
        int height = large.getHeight() / factor;
        BufferedImage small = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        int[] square = new int[factor * factor];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                large.getRGB(x * factor, y * factor, factor, factor, square, 0, factor);
                small.setRGB(x, y, mean(square, 16) | mean(square, 8) | mean(square, 0));
            }
        }
        return small;
    }

    private static int mean(int[] colours, int shift) {
        int sum = 0;
        for (int colour : colours) {
            sum += colour >> shift & 0xff;
        }
        return ((sum + colours.length / 2) / colours.length) << shift;
    }
}
