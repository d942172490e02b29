package org.auvsim.viz.drawing;

import org.auvsim.viz.scene.ActorView;
import org.auvsim.viz.scene.Meeting;
import org.auvsim.viz.scene.SceneLook;

/** Crosses where robots measured that they are, and balls where objects have just met. */
final class Marks implements Part {
    private static final double CROSS = 0.02;
    private static final double DOT = 0.006;
    private static final double FLASH = 0.012;

    /** A collision is seen for so long (s of the world). */
    private static final double SEEN = 0.5;

    private final Placement place = new Placement();

    @Override
    public void paint(SceneLook look, Picture picture) {
        if (picture.options().shows(Layer.MEASUREMENTS)) {
            for (int i = 0; i < look.count(); i++) {
                if (look.actor(i).isMeasured()) {
                    measured(look.actor(i), picture);
                }
            }
        }
        if (picture.options().shows(Layer.CONTACTS)) {
            for (int i = 0; i < look.meetings().size(); i++) {
                contact(look.meetings().get(i), look.time(), picture);
            }
        }
    }

    /**
     * A cross there, and a line from the object to it: that is how far the model was off. An object
     * that is corrected to there does not hide them.
     */
    private void measured(ActorView actor, Picture picture) {
        double x = actor.measuredPosition(0);
        double y = actor.measuredPosition(1);
        double z = actor.measuredPosition(2);
        double arm = picture.share(CROSS);
        Brush brush = picture.brush();
        brush.lineBefore(x - arm, y, z, x + arm, y, z, Palette.MEASURED);
        brush.lineBefore(x, y - arm, z, x, y + arm, z, Palette.MEASURED);
        brush.lineBefore(x, y, z - arm, x, y, z + arm, Palette.MEASURED);
        brush.lineBefore(
                actor.position(0), actor.position(1), actor.position(2), x, y, z, Palette.MEASURED);
        place.at(x, y, z);
        brush.ball(place.pose, picture.share(DOT), Palette.MEASURED);
    }

    private void contact(Meeting meeting, double time, Picture picture) {
        double age = time - meeting.time();
        if (age < 0 || age > SEEN) {
            return;
        }
        place.at(meeting.point().x(), meeting.point().y(), meeting.point().z());
        int alpha = (int) (0xff * (1 - age / SEEN));
        picture.brush()
                .ball(
                        place.pose,
                        picture.share(FLASH) * (1 + age / SEEN),
                        Palette.faded(Palette.CONTACT, alpha));
    }
}
