package org.auvsim.viz.driving;

import org.auvsim.core.actuator.Fin;
import org.auvsim.core.math.Vec3;

import java.util.List;
import java.util.Map;

/** Turns fins so that their lift turns the body as wanted, whether it goes ahead or astern. */
final class Steerage {
    private static final Vec3 AHEAD = new Vec3(1, 0, 0);

    private final List<Fin> fins;

    /** The moment that an angle brings at speed ahead, as a share of that of the best fin. */
    private final double[] yaw;

    private final double[] pitch;

    Steerage(List<Fin> fins, Vec3 centre) {
        this.fins = fins.stream().filter(fin -> fin.maximumAngle() > 0).toList();
        yaw = new double[this.fins.size()];
        pitch = new double[this.fins.size()];
        for (int i = 0; i < yaw.length; i++) {
            Fin fin = this.fins.get(i);
            Vec3 lift = fin.span().cross(AHEAD).times(fin.area() * fin.liftSlope());
            Vec3 torque = fin.position().minus(centre).cross(lift);
            yaw[i] = torque.z();
            pitch[i] = -torque.y();
        }
        share(yaw);
        share(pitch);
    }

    private static void share(double[] moments) {
        double largest = 0;
        for (double moment : moments) {
            largest = Math.max(largest, Math.abs(moment));
        }
        for (int i = 0; i < moments.length && largest > 0; i++) {
            moments[i] /= largest;
        }
    }

    /** Writes the angles (rad) by name, within what each fin allows. */
    void steer(Wanted wanted, boolean isAstern, Map<String, Double> angles) {
        // What flows from astern lifts a fin to its other side.
        double flow = isAstern ? -1 : 1;
        for (int i = 0; i < yaw.length; i++) {
            Fin fin = fins.get(i);
            double part = flow * (wanted.yaw() * yaw[i] + wanted.pitch() * pitch[i]);
            double most = Math.min(fin.maximumAngle(), fin.stallAngle());
            angles.put(fin.name(), Math.clamp(part, -1, 1) * most + 0.0);
        }
    }
}
