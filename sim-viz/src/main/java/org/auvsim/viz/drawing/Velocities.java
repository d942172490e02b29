package org.auvsim.viz.drawing;

import org.auvsim.viz.scene.ActorView;
import org.auvsim.viz.scene.SceneLook;

/** Arrows to where objects would be in a second. */
final class Velocities implements Part {
    private final Arrow arrow = new Arrow();

    @Override
    public void paint(SceneLook look, Picture picture) {
        if (!picture.options().shows(Layer.VELOCITIES)) {
            return;
        }
        for (int i = 0; i < look.count(); i++) {
            ActorView actor = look.actor(i);
            if (!actor.object().isFixed()) {
                arrow.paint(
                        actor.position(0),
                        actor.position(1),
                        actor.position(2),
                        actor.velocity(0),
                        actor.velocity(1),
                        actor.velocity(2),
                        Palette.VELOCITY,
                        picture);
            }
        }
    }
}
