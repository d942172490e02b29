package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.apache.commons.math3.util.FastMath;

import java.util.List;
import java.util.SplittableRandom;

/** What is drawn by lot, from a seed. */
final class Draws {
    private final SplittableRandom random;

    Draws(long seed) {
        this(new SplittableRandom(seed));
    }

    private Draws(SplittableRandom random) {
        this.random = random;
    }

    /** Draws of their own: how many are made of them does not change those that follow here. */
    Draws split() {
        return new Draws(random.split());
    }

    long seed() {
        return random.nextLong();
    }

    double between(double low, double high) {
        return random.nextDouble(low, high);
    }

    /** Every factor is as likely as another. */
    double logBetween(double low, double high) {
        return FastMath.exp(random.nextDouble(FastMath.log(low), FastMath.log(high)));
    }

    double sign() {
        return random.nextBoolean() ? 1 : -1;
    }

    boolean chance(double probability) {
        return random.nextDouble() < probability;
    }

    <T> T oneOf(List<T> list) {
        return list.get(random.nextInt(list.size()));
    }

    double normal() {
        return random.nextGaussian();
    }

    /** Student's t with three degrees of freedom, scaled to a variance of 1. */
    double heavyTailed() {
        double chiSquare = 0;
        for (int i = 0; i < 3; i++) {
            double g = normal();
            chiSquare += g * g;
        }
        return normal() / FastMath.sqrt(chiSquare);
    }

    /** A vector whose coordinates are normal with a deviation. */
    Vector3D normals(double deviation) {
        return new Vector3D(deviation * normal(), deviation * normal(), deviation * normal());
    }

    Vector3D direction() {
        return normals(1).normalize();
    }

    /** A unit vector not far from the horizon. */
    Vector3D flatDirection() {
        return new Vector3D(normal(), normal(), 0.3 * normal()).normalize();
    }

    /** Coordinates evenly between bounds. */
    Vector3D box(double low, double high) {
        return new Vector3D(between(low, high), between(low, high), between(low, high));
    }
}
