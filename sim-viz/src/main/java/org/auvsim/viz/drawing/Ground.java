package org.auvsim.viz.drawing;

import org.auvsim.viz.scene.SceneLook;

/** A grid at the height z = 0 around what is looked at, and the world's axes. */
final class Ground implements Part {
    /** So many lines to either side. */
    private static final int LINES = 20;

    /** A square is at least this part of the picture's height. */
    private static final double SQUARE = 0.06;

    private static final double AXIS = 0.12;

    @Override
    public void paint(SceneLook look, Picture picture) {
        if (picture.options().shows(Layer.GRID)) {
            grid(picture);
        }
        if (picture.options().shows(Layer.AXES)) {
            double length = picture.share(AXIS);
            picture.brush().line(0, 0, 0, length, 0, 0, Palette.X_AXIS);
            picture.brush().line(0, 0, 0, 0, length, 0, Palette.Y_AXIS);
            picture.brush().line(0, 0, 0, 0, 0, length, Palette.Z_AXIS);
            picture.brush().label(length, 0, 0, "x", Palette.X_AXIS);
            picture.brush().label(0, length, 0, "y", Palette.Y_AXIS);
            picture.brush().label(0, 0, length, "z", Palette.Z_AXIS);
        }
    }

    private static void grid(Picture picture) {
        double square = round(picture.share(SQUARE));
        double x = square * Math.rint(picture.camera().target(0) / square);
        double y = square * Math.rint(picture.camera().target(1) / square);
        double reach = LINES * square;
        int colour = picture.palette().grid();
        for (int i = -LINES; i <= LINES; i++) {
            double at = i * square;
            picture.brush().line(x + at, y - reach, 0, x + at, y + reach, 0, colour);
            picture.brush().line(x - reach, y + at, 0, x + reach, y + at, 0, colour);
        }
    }

    /** The next of 1, 2, 5, 10, 20 ... m, and of their tenths. */
    static double round(double metres) {
        double decade = Math.pow(10, Math.floor(Math.log10(metres)));
        double lead = metres / decade;
        return decade * (lead <= 1 ? 1 : lead <= 2 ? 2 : lead <= 5 ? 5 : 10);
    }
}
