package org.auvsim.diagnosis.cause;

import org.auvsim.core.effect.AnisotropicDrag;
import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.Derivative;
import org.auvsim.core.effect.HydrodynamicDerivatives;
import org.auvsim.core.effect.IsotropicDrag;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.MotionAxis;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.server.feedback.RigidMotion;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * The drag that a model has already, by body axis: what may be taken away from it until nothing is
 * left.
 */
final class PresentDrag {
    private static final int AXES = 6;

    /** Of a unit of speed so much is left, where a mount leaves any. */
    private static final double FREE = 0.1;

    private static final String FORCES = "XYZKMN";
    private static final String VELOCITIES = "uvwpqr";

    private final double[] linear = new double[AXES];
    private final double[] quadratic = new double[AXES];
    private final BelievedModel model;

    private PresentDrag(BelievedModel model) {
        this.model = model;
    }

    static PresentDrag of(Setting s) {
        PresentDrag drag = new PresentDrag(s.model());
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

    /** The least along the axes along which the body moves, at a speed (m/s). */
    double least(double speed) {
        return least(0, speed);
    }

    /** The least about the axes about which it turns, at a rate (rad/s). */
    double leastAngular(double rate) {
        return least(AXES / 2, rate);
    }

    private double least(int first, double speed) {
        return IntStream.range(first, first + AXES / 2)
                .filter(this::isFree)
                .mapToDouble(axis -> of(axis, speed))
                .min()
                .orElse(0);
    }

    /** Whether no mount holds it, as it is turned at the start. */
    private boolean isFree(int axis) {
        double[] unit = new double[AXES / 2];
        unit[axis % unit.length] = 1;
        Vec3 along = model.start().orientation().rotate(new Vec3(unit[0], unit[1], unit[2]));
        double[] change = new double[RigidMotion.SIZE];
        int at = AXES + axis - axis % unit.length;
        change[at] = along.x();
        change[at + 1] = along.y();
        change[at + 2] = along.z();
        return Arrays.stream(model.free(change)).anyMatch(left -> Math.abs(left) > FREE);
    }
}
