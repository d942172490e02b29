package org.auvsim.viz.drawing;

import org.auvsim.core.math.Vec3;
import org.auvsim.viz.scene.SceneLook;
import org.auvsim.viz.scene.Water;

/** Arrows of the water's velocity on a square around what is looked at, at its depth. */
final class Currents implements Part {
    private static final int ARROWS = 9;
    private static final double SQUARE = 0.11;

    /** The water is asked again when the world's time has gone on by this much (s). */
    private static final double AGE = 0.2;

    /** It is asked again when what is looked at is deeper by this part of a square. */
    private static final double DEPTH = 0.02;

    private final Arrow arrow = new Arrow();
    private final double[] places = new double[3 * ARROWS * ARROWS];
    private final double[] velocities = new double[3 * ARROWS * ARROWS];
    private Water water = Water.STILL;
    private double square;
    private double x;
    private double y;
    private double z;
    private double time = Double.NaN;
    private double fastest;

    @Override
    public void paint(SceneLook look, Picture picture) {
        if (!look.water().equals(water)) {
            water = look.water();
            time = Double.NaN;
        }
        if (!picture.options().shows(Layer.CURRENTS) || water.isStill()) {
            return;
        }
        ask(look.time(), picture);
        if (fastest == 0) {
            return;
        }
        double scale = 0.85 * square / fastest;
        for (int i = 0; i < places.length; i += 3) {
            arrow.paint(
                    places[i],
                    places[i + 1],
                    places[i + 2],
                    velocities[i] * scale,
                    velocities[i + 1] * scale,
                    velocities[i + 2] * scale,
                    Palette.CURRENT,
                    picture);
        }
    }

    private void ask(double now, Picture picture) {
        double newSquare = Ground.round(picture.share(SQUARE));
        double newX = newSquare * Math.rint(picture.camera().target(0) / newSquare);
        double newY = newSquare * Math.rint(picture.camera().target(1) / newSquare);
        double newZ = picture.camera().target(2);
        boolean same =
                newSquare == square
                        && newX == x
                        && newY == y
                        && Math.abs(newZ - z) < DEPTH * newSquare
                        && Math.abs(now - time) < AGE;
        if (same) {
            return;
        }
        square = newSquare;
        x = newX;
        y = newY;
        z = newZ;
        time = now;
        fill();
    }

    private void fill() {
        fastest = 0;
        for (int i = 0; i < ARROWS; i++) {
            for (int j = 0; j < ARROWS; j++) {
                int at = 3 * (i * ARROWS + j);
                places[at] = x + (i - ARROWS / 2) * square;
                places[at + 1] = y + (j - ARROWS / 2) * square;
                places[at + 2] = z;
                Vec3 sum = water.velocity(new Vec3(places[at], places[at + 1], z), time);
                velocities[at] = sum.x();
                velocities[at + 1] = sum.y();
                velocities[at + 2] = sum.z();
                fastest = Math.max(fastest, sum.norm());
            }
        }
    }
}
