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

    /** From further away than so many ranges of the path it would pull alike everywhere. */
    private static final double FAR = 3;

    /** Paths are in a plane that leave it by less than this share of their range. */
    private static final double FLAT = 1e-3;

    /** A little way out of that plane. */
    private static final double BESIDE = 0.3;

    /** Shares of the path along which a line to begin with is slack. */
    private static final double[] SLACK = {0.5, 0.8};

    private PlaceCauses() {}

    static List<Cause> of(Setting s) {
        return s.path().places().isEmpty() ? List.of() : List.of(magnet(s), tether(s));
    }

    /**
     * Its strength is searched for as the force that it exerts along the path, on average: that is
     * nearly the same wherever the source may be, while the strength goes by the fourth power of
     * its distance.
     */
    private static Cause magnet(Setting s) {
        Path path = s.path();
        double r = path.radius();
        List<Parameter> parameters =
                new ArrayList<>(
                        List.of(
                                source(path, "source.x", path.centre().x()),
                                source(path, "source.y", path.centre().y()),
                                source(path, "source.z", path.centre().z())));
        parameters.add(Parameter.signed("pull", "N", s.force()));
        List<Guess> guesses = new ArrayList<>();
        for (double distance : DISTANCES) {
            for (Vec3 way : directions(path)) {
                Vec3 p = path.centre().plus(way.times(distance * r));
                guesses.add(Change.guess(parameters, new double[] {p.x(), p.y(), p.z(), 0}, 3));
            }
        }
        double closest = 0.005 * path.range();
        return Change.of(
                        "magnetic",
                        parameters,
                        (v, t) ->
                                v.with(
                                        b ->
                                                b.effect(
                                                        new MagneticAttraction(
                                                                strength(path, t, closest),
                                                                place(t),
                                                                closest))))
                .from(guesses)
                .told(
                        t ->
                                List.of(
                                        new Quantity("source.x", "m", t[0]),
                                        new Quantity("source.y", "m", t[1]),
                                        new Quantity("source.z", "m", t[2]),
                                        new Quantity(
                                                "strength", "N m^4", strength(path, t, closest))));
    }

    private static Parameter source(Path path, String name, double middle) {
        double range = path.range();
        return new Parameter(name, "m", 0.05 * range, middle - FAR * range, middle + FAR * range);
    }

    private static Vec3 place(double[] theta) {
        return new Vec3(theta[0], theta[1], theta[2]);
    }

    private static double strength(Path path, double[] theta, double closest) {
        Vec3 source = place(theta);
        return theta[3]
                / path.mean(
                        p -> {
                            double distance = Math.max(closest, p.distance(source));
                            return 1 / (distance * distance * distance * distance);
                        });
    }

    /**
     * To the middles of the faces, edges and corners of a cube. From a path in a plane to one side
     * of that, as the other is its mirror image; and never within it, where no step along its
     * normal would show.
     */
    private static List<Vec3> directions(Path path) {
        List<Vec3> directions = new ArrayList<>();
        for (double x : components(path, new Vec3(1, 0, 0))) {
            for (double y : components(path, new Vec3(0, 1, 0))) {
                for (double z : components(path, new Vec3(0, 0, 1))) {
                    if (x != 0 || y != 0 || z != 0) {
                        directions.add(new Vec3(x, y, z).normalized());
                    }
                }
            }
        }
        return directions;
    }

    private static List<Double> components(Path path, Vec3 axis) {
        double extent = path.high().minus(path.low()).dot(axis);
        return extent < FLAT * path.range() ? List.of(BESIDE, 1.0) : List.of(-1.0, 0.0, 1.0);
    }

    /** In place of its length is searched for by how much the path is beyond it, on average. */
    private static Cause tether(Setting s) {
        Path path = s.path();
        double range = path.range();
        List<Parameter> parameters = new ArrayList<>(Parameter.vector("anchor", "m", 0.05 * range));
        parameters.add(Parameter.signed("extension", "m", 0.05 * range));
        parameters.add(Parameter.positive("k", "N/m", s.force() / range));
        List<Guess> guesses = new ArrayList<>();
        for (int i = -1; i <= 1; i++) {
            for (int j = -1; j <= 1; j++) {
                for (int up = -1; up <= 1; up += 2) {
                    Vec3 anchor = path.centre().plus(new Vec3(i, j, up * 0.5).times(0.6 * range));
                    double distance = path.mean(anchor::distance);
                    for (double share : SLACK) {
                        double extension = distance - path.quantile(anchor, share);
                        guesses.add(
                                Change.guess(
                                        parameters,
                                        new double[] {
                                            anchor.x(), anchor.y(), anchor.z(), extension, 0
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
                                                                place(t),
                                                                Vec3.ZERO,
                                                                length(path, t),
                                                                t[4],
                                                                0))))
                .from(guesses)
                .told(
                        t ->
                                List.of(
                                        new Quantity("anchor.x", "m", t[0]),
                                        new Quantity("anchor.y", "m", t[1]),
                                        new Quantity("anchor.z", "m", t[2]),
                                        new Quantity("length", "m", length(path, t)),
                                        new Quantity("k", "N/m", t[4])));
    }

    private static double length(Path path, double[] theta) {
        return Math.max(0, path.mean(place(theta)::distance) - theta[3]);
    }
}
