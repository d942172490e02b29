package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.apache.commons.math3.util.FastMath;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;

/** What no cause of the library covers. */
final class UncoveredEffects {
    private UncoveredEffects() {}

    /** A mass that hangs in the body on a spring with a damper. */
    static Family slosh(Scene scene, Draws draws) {
        double omega = draws.between(1.5, 4) * 2 * Math.PI / scene.duration() * 3;
        double damping = draws.between(0.02, 0.1);
        Vector3D place = draws.box(-0.3, 0.3);
        Vector3D at =
                new Vector3D(
                        place.getX() * scene.plant().size().getX(),
                        place.getY() * scene.plant().size().getX(),
                        0);
        return Family.upTo(
                1.5,
                s ->
                        HiddenEffect.of(
                                "sloshing mass",
                                Map.of("share", Numbers.of(s), "omega", Numbers.of(omega)),
                                r ->
                                        r.accompanied(
                                                random ->
                                                        new Slosh(
                                                                s * scene.plant().mass(),
                                                                omega,
                                                                damping,
                                                                at))));
    }

    private record Slosh(double mass, double omega, double damping, Vector3D at)
            implements Companion {
        @Override
        public double[] start(Instant body) {
            double[] own = new double[6];
            Instant.put(body.position().add(lever(body)), own, 0);
            Instant.put(body.velocity(), own, 3);
            return own;
        }

        private Vector3D lever(Instant body) {
            return body.attitude().toWorld(at);
        }

        /** On the body at its place; the opposite moves the mass. */
        private Vector3D pull(Instant body, double[] own) {
            Vector3D lever = lever(body);
            Vector3D way = Instant.vector(own, 0).subtract(body.position().add(lever));
            Vector3D rate =
                    Instant.vector(own, 3)
                            .subtract(
                                    body.velocity().add(body.turningInWorld().crossProduct(lever)));
            return way.scalarMultiply(mass * omega * omega).add(2 * damping * omega * mass, rate);
        }

        @Override
        public double[] slopes(Instant body, double[] own) {
            double[] slopes = new double[6];
            Instant.put(Instant.vector(own, 3), slopes, 0);
            Instant.put(pull(body, own).scalarMultiply(-1 / mass), slopes, 3);
            return slopes;
        }

        @Override
        public Wrench on(Instant body, double[] own) {
            Vector3D pull = pull(body, own);
            return new Wrench(pull, lever(body).crossProduct(pull));
        }
    }

    /** Knocks at random times in random directions, others in every run. */
    static Family kicks(Scene scene, Draws draws) {
        double pause = scene.duration() / draws.between(8, 20);
        return Family.of(
                0.3 * scene.plant().mass() * scene.speed(),
                s ->
                        HiddenEffect.of(
                                "random kicks",
                                Map.of("impulse", Numbers.of(s), "pause", Numbers.of(pause)),
                                r -> r.accompanied(random -> new Knocks(random, s, pause))));
    }

    private static final class Knocks implements Companion {
        private final List<Kick> kicks = new ArrayList<>();

        Knocks(SplittableRandom random, double size, double pause) {
            double at = 0;
            while (kicks.size() < 200) {
                at += pause * random.nextExponential();
                kicks.add(
                        new Kick(
                                at,
                                new Vector3D(
                                        size * random.nextGaussian(),
                                        size * random.nextGaussian(),
                                        size * random.nextGaussian())));
            }
        }

        @Override
        public List<Kick> kicks() {
            return kicks;
        }
    }

    /** A force that follows Lorenz' equations (1963), begun elsewhere in every run. */
    static Family chaos(Scene scene, Draws draws) {
        double haste = draws.between(0.6, 1.5) * 20 / scene.duration();
        return Family.of(
                scene.plant().mass() * scene.range() / FastMath.pow(scene.duration(), 2),
                s ->
                        HiddenEffect.of(
                                "chaotic force",
                                Map.of("force", Numbers.of(s), "haste", Numbers.of(haste)),
                                r -> r.accompanied(random -> new Lorenz(random, s, haste))));
    }

    private record Lorenz(SplittableRandom random, double force, double haste)
            implements Companion {
        @Override
        public double[] start(Instant body) {
            return new double[] {
                10 * random.nextGaussian(), 10 * random.nextGaussian(), random.nextDouble(15, 35)
            };
        }

        @Override
        public double[] slopes(Instant body, double[] o) {
            return new double[] {
                haste * 10 * (o[1] - o[0]),
                haste * (o[0] * (28 - o[2]) - o[1]),
                haste * (o[0] * o[1] - 8.0 / 3 * o[2])
            };
        }

        @Override
        public Wrench on(Instant body, double[] o) {
            return Wrench.force(
                    new Vector3D(o[0] / 8, o[1] / 9, (o[2] - 23.5) / 8.6).scalarMultiply(force));
        }
    }

    /** Water that the body itself set moving, where it was some seconds ago. */
    static Family wake(Scene scene, Draws draws) {
        double width = draws.between(0.1, 0.25) * scene.range();
        double age = draws.between(0.04, 0.1) * scene.duration();
        return Family.of(
                0.5 * scene.plant().mass() / scene.duration(),
                s ->
                        HiddenEffect.of(
                                "own wake",
                                Map.of(
                                        "drag",
                                        Numbers.of(s),
                                        "width",
                                        Numbers.of(width),
                                        "age",
                                        Numbers.of(age)),
                                r -> r.accompanied(random -> new Wake(s, width, age))));
    }

    private static final class Wake implements Companion {
        private final double drag;
        private final double width;
        private final double age;
        private final List<Instant> past = new ArrayList<>();

        Wake(double drag, double width, double age) {
            this.drag = drag;
            this.width = width;
            this.age = age;
        }

        @Override
        public void remember(Instant at) {
            past.add(at);
        }

        @Override
        public Wrench on(Instant at, double[] own) {
            Vector3D flow = Vector3D.ZERO;
            for (Instant then : past) {
                double since = (at.time() - then.time()) / age;
                double off = at.position().distance(then.position()) / width;
                double share = FastMath.exp(-off * off / 2) * since * FastMath.exp(1 - since);
                flow = flow.add(share, then.velocity());
            }
            return Wrench.force(flow.scalarMultiply(drag));
        }
    }
}
