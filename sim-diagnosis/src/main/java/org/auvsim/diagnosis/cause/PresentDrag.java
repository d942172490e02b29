package org.auvsim.diagnosis.cause;

import org.auvsim.core.effect.AnisotropicDrag;
import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.Derivative;
import org.auvsim.core.effect.HydrodynamicDerivatives;
import org.auvsim.core.effect.IsotropicDrag;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.MotionAxis;
import org.auvsim.core.math.Vec3;

/**
 * The drag that a model has already, by body axis: what may be taken away from it until nothing is
 * left.
 */
final class PresentDrag {
    private static final int AXES = 6;
    private static final String FORCES = "XYZKMN";
    private static final String VELOCITIES = "uvwpqr";

    private final double[] linear = new double[AXES];
    private final double[] quadratic = new double[AXES];

    private PresentDrag() {}

    static PresentDrag of(Setting s) {
        PresentDrag drag = new PresentDrag();
        for (Effect effect : s.body().effect()) {
            switch (effect) {
                case Damping d -> {
                    drag.add(drag.linear, d.linear(), 0);
                    drag.add(drag.linear, d.angularLinear(), 3);
                    drag.add(drag.quadratic, d.quadratic(), 0);
                    drag.add(drag.quadratic, d.angularQuadratic(), 3);
                }
                case IsotropicDrag d -> {
                    drag.add(drag.linear, new Vec3(d.linear(), d.linear(), d.linear()), 0);
                    drag.add(drag.linear, new Vec3(d.angular(), d.angular(), d.angular()), 3);
                    drag.add(
                            drag.quadratic,
                            new Vec3(d.quadratic(), d.quadratic(), d.quadratic()),
                            0);
                }
                case AnisotropicDrag d -> drag.add(drag.quadratic, d.quadratic(), 0);
                case HydrodynamicDerivatives d -> d.derivative().forEach(drag::add);
                default -> {
                    // no drag
                }
            }
        }
        return drag;
    }

    private void add(double[] to, Vec3 more, int from) {
        to[from] += more.x();
        to[from + 1] += more.y();
        to[from + 2] += more.z();
    }

    /** The damping derivatives of an axis by itself, as Xu and Xu|u|: negative where they damp. */
    private void add(Derivative derivative) {
        for (MotionAxis axis : MotionAxis.values()) {
            int i = axis.index();
            String own = "" + FORCES.charAt(i) + VELOCITIES.charAt(i);
            if (derivative.name().equals(own)) {
                linear[i] -= derivative.value();
            } else if (derivative.name().equals(own + "|" + VELOCITIES.charAt(i) + "|")) {
                quadratic[i] -= derivative.value();
            }
        }
    }

    /** Along an axis (0 to 5) at a speed (m/s or rad/s): force by speed, 0 or more. */
    double of(int axis, double speed) {
        return Math.max(0, linear[axis] + quadratic[axis] * speed);
    }

    /** The least along the three axes at a speed (m/s). */
    double least(double speed) {
        return Math.min(of(0, speed), Math.min(of(1, speed), of(2, speed)));
    }

    /** The least about the three axes at a rate (rad/s). */
    double leastAngular(double rate) {
        return Math.min(of(3, rate), Math.min(of(4, rate), of(5, rate)));
    }
}
