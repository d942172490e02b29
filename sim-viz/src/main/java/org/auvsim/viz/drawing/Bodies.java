package org.auvsim.viz.drawing;

import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.HalfSpace;
import org.auvsim.core.volume.HeightMap;
import org.auvsim.core.volume.Volume;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.scene.ActorView;
import org.auvsim.viz.scene.SceneLook;

/** The objects, and as ghosts where the step under way will bring them. */
final class Bodies implements Part {
    /** A wall that hides the rest is seen through. */
    private static final int WALL_ALPHA = 0x38;

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

    private int colour(ActorView actor, Picture picture) {
        int colour = opaque(actor, picture);
        return actor.object().isFixed() && hides(actor, picture.camera())
                ? Palette.faded(colour, WALL_ALPHA)
                : colour;
    }

    private static int opaque(ActorView actor, Picture picture) {
        if (picture.options().isSelected(actor.object().id())) {
            return picture.palette().chosen();
        }
        if (!actor.object().isFixed()) {
            return Palette.of(actor.object());
        }
        return isGround(actor) ? picture.palette().ground() : picture.palette().fixed();
    }

    /** Whether the camera is in or behind a wall or the ground, seen from what it looks at. */
    private boolean hides(ActorView wall, OrbitCamera camera) {
        if (wall.object().definition().isEmpty()) {
            return false;
        }
        Volume volume = wall.object().definition().get().volume();
        int across =
                switch (volume) {
                    case HalfSpace _ -> 2;
                    case Box box -> thinnest(box.size());
                    default -> -1;
                };
        if (across < 0) {
            return false;
        }
        double half = volume instanceof Box box ? box.size().component(across) / 2 : 0;
        double target = side(camera.target(0), camera.target(1), camera.target(2), across);
        double stand = side(camera.position(0), camera.position(1), camera.position(2), across);
        return target != 0 && stand * Math.signum(target) < half;
    }

    private static int thinnest(Vec3 size) {
        double least = Math.min(size.x(), Math.min(size.y(), size.z()));
        return size.x() == least ? 0 : size.y() == least ? 1 : 2;
    }

    /** How far a point is from the middle of the body in place, along one of its axes. */
    private double side(double x, double y, double z, int axis) {
        double ex = axis == 0 ? 1 : 0;
        double ey = axis == 1 ? 1 : 0;
        double ez = axis == 2 ? 1 : 0;
        return (x - place.pose.x) * place.world(0, ex, ey, ez)
                + (y - place.pose.y) * place.world(1, ex, ey, ez)
                + (z - place.pose.z) * place.world(2, ex, ey, ez);
    }

    private static boolean isGround(ActorView actor) {
        return actor.object().definition().isPresent()
                && (actor.object().definition().get().volume() instanceof HalfSpace
                        || actor.object().definition().get().volume() instanceof HeightMap);
    }
}
