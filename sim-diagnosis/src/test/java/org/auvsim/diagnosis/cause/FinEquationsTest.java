package org.auvsim.diagnosis.cause;

import static org.auvsim.diagnosis.cause.CauseCase.about;
import static org.auvsim.diagnosis.cause.CauseCase.cause;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.auvsim.diagnosis.cause.RigidBodyEquations.Load;
import org.auvsim.diagnosis.cause.RigidBodyEquations.Push;

import java.util.stream.Stream;

/** Fins and the hull that lifts. */
class FinEquationsTest extends CauseEquationsContract {
    /** A fin across the stream, which is attached at all angles of the run. */
    private static String fin(double area, double race, String span) {
        return """
        <fin name="rudder" area="%s" lift-slope="2" density="1000" race="%s" angle="0.2" stall-angle="1.5">
          <position x="-0.4" y="0" z="0"/>%s
        </fin>
        """
                .formatted(area, race, span);
    }

    private static final String UPRIGHT = "<span x=\"0\" y=\"0\" z=\"1\"/>";
    private static final String LEVEL = "<span x=\"0\" y=\"1\" z=\"0\"/>";

    /** The lift of that fin, if it stands upright. */
    private static Push lift(double area, double race) {
        return lift(area, race, 0.2);
    }

    /** The same at an angle (rad). */
    private static Push lift(double area, double race, double angle) {
        Vector3D place = new Vector3D(-0.4, 0, 0);
        return n -> {
            Vector3D v =
                    n.toBody(n.velocity())
                            .add(n.turning().crossProduct(place))
                            .add(race, Vector3D.PLUS_I);
            double attack = angle - Math.atan2(v.getY(), v.getX());
            double size = 0.5 * 1000 * area * Math.hypot(v.getX(), v.getY()) * 2 * attack;
            Vector3D force = new Vector3D(-v.getY(), v.getX(), 0).scalarMultiply(size);
            return new Load(n.toWorld(force), place.crossProduct(force));
        };
    }

    @Override
    Stream<CauseCase> cases() {
        double none = 1e-12;
        return Stream.of(
                about("rudder", cause("fin_gain", fin(0.01, 0.3, UPRIGHT), lift(0.015, 0.3), 0.5)),
                about(
                        "rudder",
                        cause("fin_offset", fin(0.01, 0, UPRIGHT), lift(0.01, 0, 0.3), 0.1)),
                about("rudder", cause("fin_race", fin(0.01, 0.3, UPRIGHT), lift(0.01, 1), 0.7)),
                about(
                        "sway and yaw",
                        cause(
                                "hull_lift",
                                fin(none, 0, UPRIGHT),
                                n -> {
                                    Vector3D v = n.toBody(n.velocity());
                                    double r = n.turning().getZ();
                                    double u = v.getX();
                                    return new Load(
                                            n.toWorld(
                                                    new Vector3D(
                                                            0, u * (-9 * v.getY() + 3 * r), 0)),
                                            new Vector3D(0, 0, u * (2 * v.getY() - 4 * r)));
                                },
                                -9,
                                3,
                                2,
                                -4)),
                about(
                        "heave and pitch",
                        cause(
                                "hull_lift",
                                fin(none, 0, LEVEL),
                                n -> {
                                    Vector3D v = n.toBody(n.velocity());
                                    double q = n.turning().getY();
                                    double u = v.getX();
                                    return new Load(
                                            n.toWorld(
                                                    new Vector3D(
                                                            0, 0, u * (-9 * v.getZ() - 3 * q))),
                                            new Vector3D(0, u * (-2 * v.getZ() - 4 * q), 0));
                                },
                                -9,
                                -3,
                                -2,
                                -4)));
    }
}
