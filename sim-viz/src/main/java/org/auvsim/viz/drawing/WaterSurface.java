package org.auvsim.viz.drawing;

import org.auvsim.core.effect.Buoyancy;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Field;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.viz.scene.SceneLook;

import java.util.List;

/** The surface of the water, where something swims or water moves, and the waves on it. */
final class WaterSurface implements Part {
    private static final double WIDE = 6;

    /** Waves are drawn as lines through so many places each way. */
    private static final int PLACES = 40;

    private static final double SQUARE = 0.04;

    private final Placement place = new Placement();

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
        if (hasWaves(look.fields())) {
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
        return hasCurrent(look.fields()) ? 0 : Double.NaN;
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

    private static boolean hasCurrent(List<Field<?>> fields) {
        for (int k = 0; k < fields.size(); k++) {
            if (fields.get(k) instanceof Current) {
                return true;
            }
        }
        return false;
    }

    private static boolean hasWaves(List<Field<?>> fields) {
        for (int k = 0; k < fields.size(); k++) {
            boolean waves =
                    fields.get(k) instanceof Current current
                            && (current.elevation(0.3, 0.7, 0.1) != 0
                                    || current.elevation(1.9, 0.2, 0.7) != 0);
            if (waves) {
                return true;
            }
        }
        return false;
    }

    private static void waves(SceneLook look, double height, Picture picture) {
        double square = picture.share(SQUARE);
        double x = square * Math.rint(picture.camera().target(0) / square - PLACES / 2.0);
        double y = square * Math.rint(picture.camera().target(1) / square - PLACES / 2.0);
        int colour = Palette.faded(picture.palette().water(), 0xb0);
        for (int i = 0; i <= PLACES; i++) {
            for (int j = 0; j < PLACES; j++) {
                wave(look, x + i * square, y + j * square, 0, square, height, colour, picture);
                wave(look, x + j * square, y + i * square, square, 0, height, colour, picture);
            }
        }
    }

    private static void wave(
            SceneLook look,
            double x,
            double y,
            double dx,
            double dy,
            double height,
            int colour,
            Picture picture) {
        double here = height + elevation(look, x, y);
        double there = height + elevation(look, x + dx, y + dy);
        picture.brush().line(x, y, here, x + dx, y + dy, there, colour);
    }

    private static double elevation(SceneLook look, double x, double y) {
        double sum = 0;
        for (int k = 0; k < look.fields().size(); k++) {
            if (look.fields().get(k) instanceof Current current) {
                sum += current.elevation(x, y, look.time());
            }
        }
        return sum;
    }
}
