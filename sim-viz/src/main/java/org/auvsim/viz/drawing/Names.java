package org.auvsim.viz.drawing;

import org.auvsim.viz.scene.ActorView;
import org.auvsim.viz.scene.SceneLook;

/** The names of objects, above them; in a crowd only that of what is selected or followed. */
final class Names implements Part {
    private static final int CROWD = 40;
    private static final double ABOVE = 0.015;

    private final Placement place = new Placement();

    @Override
    public void paint(SceneLook look, Picture picture) {
        if (!picture.options().shows(Layer.LABELS)) {
            return;
        }
        for (int i = 0; i < look.count(); i++) {
            ActorView actor = look.actor(i);
            long id = actor.object().id();
            boolean chosen = picture.options().isSelected(id) || picture.options().isFollowed(id);
            if (chosen || (look.count() <= CROWD && isBounded(actor))) {
                name(actor, picture);
            }
        }
    }

    private void name(ActorView actor, Picture picture) {
        double above = reach(actor, picture) + picture.share(ABOVE);
        picture.brush()
                .label(
                        actor.position(0) + above * picture.camera().up(0),
                        actor.position(1) + above * picture.camera().up(1),
                        actor.position(2) + above * picture.camera().up(2),
                        actor.object().name(),
                        picture.palette().words());
    }

    private static boolean isBounded(ActorView actor) {
        return actor.object().definition().isEmpty()
                || actor.object().definition().get().volume().isBounded();
    }

    /** How far it reaches towards the picture's top (m). */
    private double reach(ActorView actor, Picture picture) {
        if (actor.object().definition().isEmpty() || !isBounded(actor)) {
            return 0;
        }
        place.of(actor);
        return actor.object()
                .definition()
                .get()
                .volume()
                .reach(
                        place.pose,
                        picture.camera().up(0),
                        picture.camera().up(1),
                        picture.camera().up(2));
    }
}
