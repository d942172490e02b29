package org.auvsim.viz.drawing;

import org.auvsim.core.effect.Buoyancy;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.viz.scene.SceneLook;
import org.auvsim.viz.scene.Water;

/** The surface of the water, where something swims or water moves, and the waves on it. */
final class WaterSurface implements Part {
    private static final double WIDE = 6;

    /** Waves are drawn as lines through so many places each way. */
    private static final int PLACES = 40;

    private static final double SQUARE = 0.04;

    private final Placement place = new Placement();

    /** Of the waves (m) over the row of places that was asked for last. */
    private final double[] heights = new double[PLACES + 1];

    @Override
    public void paint(SceneLook look, Picture picture) {
        if (!picture.options().shows(Layer.WATER)) {
            return;
        }
        double height = height(look);
        if (Double.isNaN(height)) {
            return;
        }
        place.at(picture.camera().target(0), picture.camera().target(1), height);
        double wide = picture.share(WIDE);
        picture.brush().box(place.pose, wide, wide, 0, picture.palette().water());
        if (hasWaves(look.water())) {
            waves(look, height, picture);
        }
    }

    /** The height of still water (m); not a number where there is none. */
    private static double height(SceneLook look) {
        for (int i = 0; i < look.count(); i++) {
            if (look.actor(i).object().definition().isPresent()) {
                double height = height(look.actor(i).object().definition().get());
                if (!Double.isNaN(height)) {
                    return height;
                }
            }
        }
        return look.water().isStill() ? Double.NaN : 0;
    }

    private static double height(WorldObjectDefinition definition) {
        for (int k = 0; k < definition.effect().size(); k++) {
            Effect effect = definition.effect().get(k);
            if (effect instanceof Buoyancy buoyancy) {
                return buoyancy.surface();
            }
        }
        return Double.NaN;
    }

    private static boolean hasWaves(Water water) {
        return water.elevation(0.3, 0.7, 0.1) != 0 || water.elevation(1.9, 0.2, 0.7) != 0;
    }

    private void waves(SceneLook look, double height, Picture picture) {
        double square = picture.share(SQUARE);
        double x = square * Math.rint(picture.camera().target(0) / square - PLACES / 2.0);
        double y = square * Math.rint(picture.camera().target(1) / square - PLACES / 2.0);
        int colour = Palette.faded(picture.palette().water(), 0xb0);
        for (int i = 0; i <= PLACES; i++) {
            for (int j = 0; j <= PLACES; j++) {
                double px = x + i * square;
                double py = y + j * square;
                double pz = height + look.water().elevation(px, py, look.time());
                if (i > 0) {
                    picture.brush().line(px - square, py, heights[j], px, py, pz, colour);
                }
                if (j > 0) {
                    picture.brush().line(px, py - square, heights[j - 1], px, py, pz, colour);
                }
                heights[j] = pz;
            }
        }
    }
}
