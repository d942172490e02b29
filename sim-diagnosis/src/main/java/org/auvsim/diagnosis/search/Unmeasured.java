package org.auvsim.diagnosis.search;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.result.Axis;
import org.auvsim.diagnosis.result.Numbers;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.OrientationError;
import org.auvsim.server.feedback.RigidMotion;

import java.util.List;

/**
 * Where two models that predict the same of all that was measured part: in what was not. The bodies
 * themselves are compared, as another sensor would tell of them, and not what the sensors at hand
 * make of them.
 */
final class Unmeasured {
    private static final String AXES = "xyz";

    /** Models part where they differ by such a share of what the channel does at all. */
    private static final double PARTING = 0.1;

    /** Below this (m, rad, m/s, rad/s) it is rounding. */
    private static final double ROUNDING = 1e-6;

    private final Judged one;
    private final Judged other;

    Unmeasured(Judged one, Judged other) {
        this.one = one;
        this.other = other;
    }

    /**
     * Where they part most, and how far: {@code velocity along x, by 0.30 m/s (root mean square)};
     * empty if they part nowhere.
     */
    String words() {
        String words = "";
        double most = PARTING;
        List<RigidMotion[]> motions = one.fit().motions();
        List<RigidMotion[]> others = other.fit().motions();
        for (Channel channel : Channel.values()) {
            double[] apart = new double[3];
            double all = 0;
            int count = 0;
            for (int r = 0; r < motions.size(); r++) {
                RigidMotion[] a = motions.get(r);
                RigidMotion[] b = others.get(r);
                count += a.length;
                for (int k = 0; k < a.length; k++) {
                    Vec3 between = between(channel, a[k], b[k]);
                    Vec3 does = does(channel, a[0], a[k]);
                    for (int axis = 0; axis < 3; axis++) {
                        apart[axis] += between.component(axis) * between.component(axis);
                        all += does.component(axis) * does.component(axis);
                    }
                }
            }
            for (int axis = 0; axis < 3; axis++) {
                double far = Math.sqrt(apart[axis] / count);
                double share = far / Math.sqrt(all / count);
                if (!isMeasured(channel, axis) && far > ROUNDING && share > most) {
                    most = share;
                    words = words(channel, axis, far);
                }
            }
        }
        return words;
    }

    private boolean isMeasured(Channel channel, int axis) {
        return one.fit().data().stream()
                .anyMatch(run -> run.rows().contains(new Misses.Row(channel, axis)));
    }

    private static String words(Channel channel, int axis, double far) {
        return "%s, by %s %s (root mean square)"
                .formatted(
                        new Axis(Frame.WORLD, AXES.charAt(axis)).within(channel),
                        Numbers.rounded(far),
                        channel.unit());
    }

    /** How far two motions are apart, in the world's axes. */
    private static Vec3 between(Channel channel, RigidMotion a, RigidMotion b) {
        return switch (channel) {
            case POSITION -> b.position().minus(a.position());
            case ORIENTATION -> OrientationError.turn(a.orientation(), b.orientation());
            case VELOCITY -> b.velocity().minus(a.velocity());
            case ANGULAR_VELOCITY -> b.angularVelocity().minus(a.angularVelocity());
        };
    }

    /** What a motion does: from its start on, or, of velocities, at all. */
    private static Vec3 does(Channel channel, RigidMotion start, RigidMotion now) {
        return switch (channel) {
            case POSITION, ORIENTATION -> between(channel, start, now);
            case VELOCITY -> now.velocity();
            case ANGULAR_VELOCITY -> now.angularVelocity();
        };
    }
}
