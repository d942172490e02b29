package org.auvsim.viz.drawing;

import org.auvsim.core.volume.HalfSpace;
import org.auvsim.core.volume.HeightMap;
import org.auvsim.core.volume.Volume;
import org.auvsim.viz.scene.ActorView;
import org.auvsim.viz.scene.SceneLook;

/** The objects, and as ghosts where the step under way will bring them. */
final class Bodies implements Part {
    private final Shapes shapes = new Shapes();
    private final Placement place = new Placement();

    @Override
    public void paint(SceneLook look, Picture picture) {
        boolean ghosts = picture.options().shows(Layer.GHOSTS);
        for (int i = 0; i < look.count(); i++) {
            ActorView actor = look.actor(i);
            place.of(actor);
            body(actor, colour(actor, picture), picture);
            if (ghosts && actor.isProjected() && !actor.object().isFixed()) {
                place.ofProjected(actor);
                body(actor, Palette.faded(colour(actor, picture), Palette.GHOST_ALPHA), picture);
            }
        }
    }

    private void body(ActorView actor, int colour, Picture picture) {
        if (actor.object().definition().isPresent()) {
            Volume volume = actor.object().definition().get().volume();
            shapes.paint(actor.object().id(), volume, place, colour, picture);
        } else {
            shapes.unknown(place, colour, picture.brush());
        }
    }

    private static int colour(ActorView actor, Picture picture) {
        long id = actor.object().id();
        if (picture.options().isSelected(id)) {
            return picture.palette().chosen();
        }
        if (isGround(actor)) {
            return picture.palette().ground();
        }
        return actor.object().isFixed() ? picture.palette().fixed() : Palette.ofObject(id);
    }

    private static boolean isGround(ActorView actor) {
        return actor.object().definition().isPresent()
                && (actor.object().definition().get().volume() instanceof HalfSpace
                        || actor.object().definition().get().volume() instanceof HeightMap);
    }
}
