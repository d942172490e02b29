package org.auvsim.viz.drawing;

import org.auvsim.viz.scene.ActorView;
import org.auvsim.viz.scene.SceneLook;

/**
 * The names of objects, above them; in a crowd only that of what is selected or followed. Where
 * names would lie upon one another the nearest is seen, but for that of what is selected.
 */
final class Names implements Part {
    private static final int CROWD = 40;
    private static final double ABOVE = 0.015;

    private final Placement place = new Placement();
    private final Room room = new Room();
    private final double[] pixel = new double[3];
    private final double[] at = new double[3];

    /** Whose names are wanted, the most wanted first. */
    private final int[] wanted = new int[CROWD + 1];

    private final double[] depths = new double[CROWD + 1];
    private int count;

    @Override
    public void paint(SceneLook look, Picture picture) {
        if (!picture.options().shows(Layer.LABELS)) {
            return;
        }
        count = 0;
        for (int i = 0; i < look.count(); i++) {
            ActorView actor = look.actor(i);
            long id = actor.object().id();
            if (picture.options().isSelected(id)) {
                want(i, Double.NEGATIVE_INFINITY);
            } else if (picture.options().isFollowed(id)
                    || (look.count() <= CROWD && isBounded(actor))) {
                want(i, depth(actor, picture));
            }
        }
        room.clear();
        for (int k = 0; k < count; k++) {
            name(look.actor(wanted[k]), picture);
        }
    }

    private static double depth(ActorView actor, Picture picture) {
        double depth = 0;
        for (int axis = 0; axis < 3; axis++) {
            depth += actor.position(axis) * picture.camera().forward(axis);
        }
        return depth;
    }

    private void want(int actor, double depth) {
        int k = count;
        while (k > 0 && depths[k - 1] > depth) {
            wanted[k] = wanted[k - 1];
            depths[k] = depths[k - 1];
            k--;
        }
        wanted[k] = actor;
        depths[k] = depth;
        count++;
    }

    private void name(ActorView actor, Picture picture) {
        double above = reach(actor, picture) + picture.share(ABOVE);
        for (int axis = 0; axis < 3; axis++) {
            at[axis] = actor.position(axis) + above * picture.camera().up(axis);
        }
        picture.camera().project(at[0], at[1], at[2], 1, 1, pixel);
        boolean isBehind = picture.camera().isPerspective() && pixel[2] <= 0;
        String name = actor.object().name();
        if (!isBehind && room.take(pixel[0], pixel[1], name, picture.brush().letters())) {
            picture.brush().label(at[0], at[1], at[2], name, picture.palette().words());
        }
    }

    private static boolean isBounded(ActorView actor) {
        return actor.radius() < Double.POSITIVE_INFINITY;
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
