package org.auvsim.diagnosis.cause;

import static org.auvsim.diagnosis.cause.CauseCase.cause;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.auvsim.diagnosis.cause.RigidBodyEquations.Load;
import org.auvsim.diagnosis.cause.RigidBodyEquations.Now;

import java.util.stream.Stream;

/** Thrusters of which one is told to go astern. */
class AsternEquationsTest extends CauseEquationsContract {
    private static final String THRUSTERS =
            """
            <propulsor name="port" maximum-thrust="20"><position x="-0.4" y="0.15" z="0"/></propulsor>
            <propulsor name="starboard" maximum-thrust="20"><position x="-0.4" y="-0.15" z="0"/></propulsor>
            """;

    @Override
    double[] levels() {
        return new double[] {-0.3, 0.2};
    }

    @Override
    Stream<CauseCase> cases() {
        return Stream.of(
                cause(
                        "thruster_astern",
                        THRUSTERS,
                        n -> thrust(n, 0.15, -6 * 0.7).plus(thrust(n, -0.15, 4)),
                        -0.3));
    }

    private static Load thrust(Now now, double side, double ahead) {
        Vector3D force = new Vector3D(ahead, 0, 0);
        return new Load(now.toWorld(force), new Vector3D(-0.4, side, 0).crossProduct(force));
    }
}
