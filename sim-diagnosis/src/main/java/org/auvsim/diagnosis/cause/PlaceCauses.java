package org.auvsim.diagnosis.cause;

import org.auvsim.core.effect.MagneticAttraction;
import org.auvsim.core.effect.Mooring;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;

/** Forces that a place of the world exerts: a magnet, the anchor of a line. */
final class PlaceCauses {
    /** Distances of magnets to begin with from the path's middle, in its radii. */
    private static final double[] DISTANCES = {0.7, 1.4};

    /** Shares of the path along which a line to begin with is slack. */
    private static final double[] SLACK = {0.5, 0.8};

    private PlaceCauses() {}

    static List<Cause> of(Setting s) {
        return s.path().places().isEmpty() ? List.of() : List.of(magnet(s), tether(s));
    }

    private static Cause magnet(Setting s) {
        double r = s.path().radius();
        List<Parameter> parameters =
                new ArrayList<>(Parameter.vector("source", "m", 0.05 * s.path().range()));
        parameters.add(Parameter.signed("strength", "N m^4", s.force() * r * r * r * r));
        List<Guess> guesses = new ArrayList<>();
        for (double distance : DISTANCES) {
            for (Vec3 way : directions()) {
                Vec3 p = s.path().centre().plus(way.times(distance * r));
                guesses.add(Change.guess(parameters, new double[] {p.x(), p.y(), p.z(), 0}, 3));
            }
        }
        double closest = 0.005 * s.path().range();
        return Change.of(
                        "magnetic",
                        parameters,
                        (v, t) ->
                                v.with(
                                        b ->
                                                b.effect(
                                                        new MagneticAttraction(
                                                                t[3],
                                                                new Vec3(t[0], t[1], t[2]),
                                                                closest))))
                .from(guesses);
    }

    /** To the middles of the faces, edges and corners of a cube. */
    private static List<Vec3> directions() {
        List<Vec3> directions = new ArrayList<>();
        for (int x = -1; x <= 1; x++) {
            for (int y = -1; y <= 1; y++) {
                for (int z = -1; z <= 1; z++) {
                    if (x != 0 || y != 0 || z != 0) {
                        directions.add(new Vec3(x, y, z).normalized());
                    }
                }
            }
        }
        return directions;
    }

    private static Cause tether(Setting s) {
        Path path = s.path();
        double range = path.range();
        List<Parameter> parameters = new ArrayList<>(Parameter.vector("anchor", "m", 0.05 * range));
        parameters.add(new Parameter("length", "m", 0.05 * range, 0, 100 * range));
        parameters.add(Parameter.positive("k", "N/m", s.force() / range));
        List<Guess> guesses = new ArrayList<>();
        for (int i = -1; i <= 1; i++) {
            for (int j = -1; j <= 1; j++) {
                for (int up = -1; up <= 1; up += 2) {
                    Vec3 anchor = path.centre().plus(new Vec3(i, j, up * 0.5).times(0.6 * range));
                    for (double share : SLACK) {
                        double length = path.quantile(anchor, share);
                        guesses.add(
                                Change.guess(
                                        parameters,
                                        new double[] {
                                            anchor.x(), anchor.y(), anchor.z(), length, 0
                                        },
                                        4));
                    }
                }
            }
        }
        return Change.of(
                        "tether_spring",
                        parameters,
                        (v, t) ->
                                v.with(
                                        b ->
                                                b.effect(
                                                        new Mooring(
                                                                new Vec3(t[0], t[1], t[2]),
                                                                Vec3.ZERO,
                                                                t[3],
                                                                t[4],
                                                                0))))
                .from(guesses);
    }
}
