package org.auvsim.diagnosis.cause;

import static org.auvsim.diagnosis.cause.CauseCase.cause;
import static org.auvsim.diagnosis.cause.CauseCase.drag;
import static org.auvsim.diagnosis.cause.CauseCase.force;
import static org.auvsim.diagnosis.cause.CauseCase.told;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.auvsim.diagnosis.cause.RigidBodyEquations.Load;

import java.util.stream.Stream;

/** Drag and currents. */
class WaterEquationsTest extends CauseEquationsContract {
    private static final Vector3D U = new Vector3D(0.3, -0.2, 0.1);

    @Override
    Stream<CauseCase> cases() {
        String dragged = "<isotropic-drag quadratic=\"5\"/>";
        return Stream.of(
                cause("linear_drag", "", force(n -> n.velocity().scalarMultiply(-3)), 3),
                cause("quadratic_drag", "", force(n -> drag(5, n.velocity())), 5),
                cause(
                        "anisotropic_drag",
                        "",
                        force(
                                n -> {
                                    Vector3D v = n.toBody(n.velocity());
                                    return n.toWorld(
                                            new Vector3D(
                                                    -2 * Math.abs(v.getX()) * v.getX(),
                                                    -5 * Math.abs(v.getY()) * v.getY(),
                                                    -9 * Math.abs(v.getZ()) * v.getZ()));
                                }),
                        2,
                        5,
                        9),
                cause(
                        "anisotropic_linear_drag",
                        "",
                        force(
                                n -> {
                                    Vector3D v = n.toBody(n.velocity());
                                    return n.toWorld(
                                            new Vector3D(
                                                    -2 * v.getX(), -5 * v.getY(), -9 * v.getZ()));
                                }),
                        2,
                        5,
                        9),
                cause(
                        "rotational_drag",
                        "",
                        n -> Load.torque(n.turning().scalarMultiply(-0.4)),
                        0.4),
                cause(
                        "magnus",
                        "",
                        force(
                                n ->
                                        n.toWorld(n.turning())
                                                .crossProduct(n.velocity())
                                                .scalarMultiply(4)),
                        4),
                cause(
                        "current_constant",
                        dragged,
                        force(n -> drag(5, n.velocity().subtract(U))),
                        0.3,
                        -0.2,
                        0.1),
                cause(
                        "current_oscillating",
                        dragged,
                        force(
                                n ->
                                        drag(
                                                5,
                                                n.velocity()
                                                        .subtract(Math.sin(2 * n.time()), U)
                                                        .subtract(
                                                                0.4 * Math.cos(2 * n.time()),
                                                                Vector3D.PLUS_I))),
                        0.3,
                        -0.2,
                        0.1,
                        0.4,
                        0,
                        0,
                        2),
                cause(
                        "current_shear",
                        dragged,
                        force(
                                n ->
                                        drag(
                                                5,
                                                n.velocity()
                                                        .subtract(
                                                                n.place().getZ(),
                                                                new Vector3D(0.2, -0.1, 0)))),
                        0.2,
                        -0.1),
                told(
                        cause(
                                "current_vortex",
                                dragged,
                                force(
                                        n -> {
                                            double x = n.place().getX() - 1;
                                            double y = n.place().getY() + 2;
                                            double rate =
                                                    6 / (2 * Math.PI * (x * x + y * y + 0.25));
                                            return drag(
                                                    5,
                                                    n.velocity()
                                                            .subtract(
                                                                    new Vector3D(
                                                                            -rate * y, rate * x,
                                                                            0)));
                                        }),
                                1,
                                -2,
                                6,
                                0.5)));
    }
}
