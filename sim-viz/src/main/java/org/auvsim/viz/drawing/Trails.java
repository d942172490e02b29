package org.auvsim.viz.drawing;

import org.auvsim.viz.scene.ActorView;
import org.auvsim.viz.scene.SceneLook;

/** Where objects have been, fading into the past. */
final class Trails implements Part {
    /** In so large a world only the trails of what is selected or followed are drawn. */
    private static final int MOST_OBJECTS = 100;

    /** How long ago a place may be to be drawn (s). */
    private static final double SECONDS = 60;

    private static final int OLDEST = 0x20;
    private static final int NEWEST = 0xe0;

    @Override
    public void paint(SceneLook look, Picture picture) {
        if (!picture.options().shows(Layer.TRAILS)) {
            return;
        }
        for (int i = 0; i < look.count(); i++) {
            ActorView actor = look.actor(i);
            long id = actor.object().id();
            boolean drawn =
                    look.count() <= MOST_OBJECTS
                            || picture.options().isSelected(id)
                            || picture.options().isFollowed(id);
            if (drawn && !actor.object().isFixed()) {
                trail(actor, look.time(), picture);
            }
        }
    }

    private static void trail(ActorView actor, double time, Picture picture) {
        int colour = Palette.of(actor.object());
        for (int i = 1; i < actor.trailLength(); i++) {
            double age = time - actor.trailTime(i);
            if (age < 0) {
                break;
            }
            if (age < SECONDS) {
                int alpha = (int) (NEWEST - (NEWEST - OLDEST) * age / SECONDS);
                boolean last = i == actor.trailLength() - 1 || actor.trailTime(i + 1) > time;
                picture.brush()
                        .line(
                                actor.trail(i - 1, 0),
                                actor.trail(i - 1, 1),
                                actor.trail(i - 1, 2),
                                actor.trail(i, 0),
                                actor.trail(i, 1),
                                actor.trail(i, 2),
                                Palette.faded(colour, alpha));
                if (last) {
                    picture.brush()
                            .line(
                                    actor.trail(i, 0),
                                    actor.trail(i, 1),
                                    actor.trail(i, 2),
                                    actor.position(0),
                                    actor.position(1),
                                    actor.position(2),
                                    Palette.faded(colour, NEWEST));
                }
            }
        }
    }
}
