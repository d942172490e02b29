package org.auvsim.diagnosis.cause;

import static org.auvsim.diagnosis.cause.CauseCase.G;
import static org.auvsim.diagnosis.cause.CauseCase.cause;
import static org.auvsim.diagnosis.cause.CauseCase.force;
import static org.auvsim.diagnosis.cause.CauseCase.loosely;
import static org.auvsim.diagnosis.cause.CauseCase.told;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

import java.util.stream.Stream;

/** Forces that go by the place or the time. */
class PlaceAndTimeEquationsTest extends CauseEquationsContract {
    @Override
    Stream<CauseCase> cases() {
        Vector3D source = new Vector3D(2, 0.5, -1);
        Vector3D push = new Vector3D(3, -2, 1);
        return Stream.of(
                told(
                        cause(
                                "magnetic",
                                "",
                                force(
                                        n -> {
                                            Vector3D d = source.subtract(n.place());
                                            return d.scalarMultiply(7 / Math.pow(d.getNorm(), 5));
                                        }),
                                2,
                                0.5,
                                -1,
                                7)),
                told(
                        cause(
                                "tether_spring",
                                "",
                                force(
                                        n -> {
                                            Vector3D d = source.subtract(n.place());
                                            double beyond = Math.max(0, d.getNorm() - 0.8);
                                            return d.scalarMultiply(6 * beyond / d.getNorm());
                                        }),
                                2,
                                0.5,
                                -1,
                                0.8,
                                6)),
                cause(
                        "wave_forcing",
                        "",
                        force(
                                n -> {
                                    double c = Math.cos(0.7);
                                    double s = Math.sin(0.7);
                                    double k = 1.5 * 9 / G;
                                    double way = c * n.place().getX() + s * n.place().getY();
                                    double angle = 3 * n.time() - k * way;
                                    double size = 4 * Math.sin(angle) + 2 * Math.cos(angle);
                                    return new Vector3D(size * c, size * s, 0);
                                }),
                        4,
                        2,
                        0.7,
                        3,
                        1.5),
                cause(
                        "periodic_force",
                        "",
                        force(
                                n ->
                                        push.scalarMultiply(Math.sin(4 * n.time()))
                                                .add(2 * Math.cos(4 * n.time()), Vector3D.PLUS_K)),
                        3,
                        -2,
                        1,
                        0,
                        0,
                        2,
                        4),
                loosely(
                        cause(
                                "step_force",
                                "",
                                force(n -> n.time() > 0.92 ? push : Vector3D.ZERO),
                                3,
                                -2,
                                1,
                                0.92)),
                loosely(
                        cause(
                                "impulse",
                                "",
                                force(n -> push.scalarMultiply(bump(n.time() - 1))),
                                3,
                                -2,
                                1,
                                1)));
    }

    /** Gauss' curve, a fiftieth of a second wide. */
    private static double bump(double x) {
        return Math.exp(-x * x / (2 * 0.02 * 0.02)) / (0.02 * Math.sqrt(2 * Math.PI));
    }
}
