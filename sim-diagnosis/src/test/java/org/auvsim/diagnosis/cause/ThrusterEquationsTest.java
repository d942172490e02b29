package org.auvsim.diagnosis.cause;

import static org.auvsim.diagnosis.cause.CauseCase.about;
import static org.auvsim.diagnosis.cause.CauseCase.cause;
import static org.auvsim.diagnosis.cause.CauseCase.loosely;

import org.apache.commons.math3.geometry.euclidean.threed.Rotation;
import org.apache.commons.math3.geometry.euclidean.threed.RotationConvention;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.auvsim.diagnosis.cause.RigidBodyEquations.Load;
import org.auvsim.diagnosis.cause.RigidBodyEquations.Now;
import org.auvsim.diagnosis.cause.RigidBodyEquations.Push;

import java.util.function.Function;
import java.util.stream.Stream;

/** Thrusters that are not as believed. */
class ThrusterEquationsTest extends CauseEquationsContract {
    /** Two of 20 N that are told 0.6 and 0.4 at time 0, in place of 0. */
    private static final String THRUSTERS =
            """
            <propulsor name="port" maximum-thrust="20"><position x="-0.4" y="0.15" z="0"/></propulsor>
            <propulsor name="starboard" maximum-thrust="20"><position x="-0.4" y="-0.15" z="0"/></propulsor>
            """;

    private static Load thrust(Now now, double side, Vector3D force) {
        Vector3D at = new Vector3D(-0.4, side, 0);
        return new Load(now.toWorld(force), at.crossProduct(force));
    }

    private static Push thrusts(Function<Now, Vector3D> port, Function<Now, Vector3D> starboard) {
        return n -> thrust(n, 0.15, port.apply(n)).plus(thrust(n, -0.15, starboard.apply(n)));
    }

    private static Vector3D ahead(double newtons) {
        return new Vector3D(newtons, 0, 0);
    }

    /** What is left of a thrust at the speed of its place through still water. */
    private static Vector3D biting(double atRest, Now now, double side) {
        Vector3D place = new Vector3D(-0.4, side, 0);
        Vector3D through = now.toBody(now.velocity()).add(now.turning().crossProduct(place));
        return ahead(atRest - 0.3 * Math.sqrt(atRest * 20) * through.getX());
    }

    @Override
    Stream<CauseCase> cases() {
        Rotation yawed = new Rotation(Vector3D.PLUS_K, 0.3, RotationConvention.VECTOR_OPERATOR);
        return Stream.of(
                about(
                        "port",
                        cause(
                                "thruster_gain",
                                THRUSTERS,
                                thrusts(n -> ahead(6), n -> ahead(8)),
                                -0.5)),
                cause("thruster_gain", THRUSTERS, thrusts(n -> ahead(6), n -> ahead(4)), -0.5),
                cause("thruster_deadzone", THRUSTERS, thrusts(n -> ahead(10), n -> ahead(6)), 0.1),
                cause(
                        "thruster_lag",
                        THRUSTERS,
                        thrusts(
                                n -> ahead(12 * (1 - Math.exp(-n.time() / 0.5))),
                                n -> ahead(8 * (1 - Math.exp(-n.time() / 0.5)))),
                        0.5),
                cause(
                        "thruster_advance",
                        THRUSTERS,
                        thrusts(n -> biting(12, n, 0.15), n -> biting(8, n, -0.15)),
                        0.3),
                cause(
                        "thruster_fade",
                        THRUSTERS,
                        thrusts(
                                n -> ahead(12 * (1 - 0.2 * n.time())),
                                n -> ahead(8 * (1 - 0.2 * n.time()))),
                        0.2),
                about(
                        "starboard",
                        cause(
                                "thruster_misalignment",
                                THRUSTERS,
                                thrusts(n -> ahead(12), n -> yawed.applyTo(ahead(8))),
                                0.3)),
                about(
                        "port",
                        loosely(
                                cause(
                                        "thruster_loss",
                                        THRUSTERS,
                                        thrusts(
                                                n -> ahead(n.time() < 1.02 ? 12 : 3),
                                                n -> ahead(8)),
                                        0.75,
                                        1.02))));
    }
}
