package org.auvsim.diagnosis.cause;

import static org.auvsim.diagnosis.cause.CauseCase.G;
import static org.auvsim.diagnosis.cause.CauseCase.INERTIA;
import static org.auvsim.diagnosis.cause.CauseCase.MASS;
import static org.auvsim.diagnosis.cause.CauseCase.NOTHING;
import static org.auvsim.diagnosis.cause.CauseCase.cause;
import static org.auvsim.diagnosis.cause.CauseCase.drag;
import static org.auvsim.diagnosis.cause.CauseCase.force;
import static org.auvsim.diagnosis.cause.CauseCase.numbers;
import static org.auvsim.diagnosis.cause.RigidBodyEquations.times;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.auvsim.diagnosis.cause.RigidBodyEquations.Load;
import org.auvsim.diagnosis.cause.RigidBodyEquations.Push;

import java.util.stream.Stream;

/** Weight, mass, inertia and friction. */
class BodyEquationsTest extends CauseEquationsContract {
    @Override
    Stream<CauseCase> cases() {
        String falling = "<gravity/><isotropic-drag quadratic=\"5\"/>";
        Vector3D offset = new Vector3D(0.02, -0.01, 0.03);
        Push weight =
                n -> Load.force(new Vector3D(0, 0, -1.2 * MASS * G).add(drag(5, n.velocity())));
        return Stream.of(
                cause("buoyancy_weight", "", force(n -> new Vector3D(0, 0, 4)), 4),
                cause(
                        "cob_offset",
                        "",
                        n ->
                                Load.torque(
                                        offset.crossProduct(
                                                n.toBody(new Vector3D(0, 0, MASS * G)))),
                        0.02,
                        -0.01,
                        0.03),
                cause(
                        "coulomb_friction",
                        "",
                        force(n -> n.velocity().normalize().scalarMultiply(-0.02 * MASS * G)),
                        0.02),
                new CauseCase(
                        "mass_error",
                        "",
                        falling,
                        numbers(0.2),
                        false,
                        new RigidBodyEquations(
                                new Vector3D(1.2 * MASS, 1.2 * MASS, 1.2 * MASS), INERTIA, weight),
                        CauseCase.SMOOTH),
                new CauseCase(
                        "inertia_error",
                        "",
                        "",
                        numbers(0.4, -0.2, 0.1),
                        false,
                        new RigidBodyEquations(
                                new Vector3D(MASS, MASS, MASS),
                                times(INERTIA, new Vector3D(1.4, 0.8, 1.1)),
                                NOTHING),
                        CauseCase.SMOOTH),
                new CauseCase(
                        "added_mass",
                        "",
                        "",
                        numbers(3, 5, 8),
                        false,
                        new RigidBodyEquations(
                                new Vector3D(MASS + 3, MASS + 5, MASS + 8), INERTIA, NOTHING),
                        CauseCase.SMOOTH));
    }
}
