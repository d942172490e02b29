package org.auvsim.experiments.workload;

import org.auvsim.core.effect.CentralForce;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;

/**
 * The workload of the thesis' section 8.2, made exact: equal spheres in cubes, driven so that the
 * cubes collapse and the spheres collide again and again.
 *
 * <p>Bodies come in clusters of at most 100, 60 m apart in a cube. A cluster of m fills the
 * smallest cubic lattice that holds it, centres 6 m apart (gaps of 5 diameters), about its origin.
 * A body is driven by {@link CentralForce}, so that energy is conserved. Positions are jittered by
 * 1e-6 m, since clusters that are copies would collide in bursts.
 *
 * @param bodies number of spheres, 1 or more
 * @param seed of the jitter
 * @param restitution of every sphere, 0 to 1
 * @param targets where they are driven to
 */
public record Workload(int bodies, long seed, double restitution, Targets targets) {
    /** Radius of a sphere (m). */
    public static final double RADIUS = 0.5;

    /** Mass of a sphere (kg). */
    public static final double MASS = 1;

    /** The force that drives a sphere (N). */
    public static final double FORCE = 10;

    /** Within this distance (m) of its target a sphere is not driven. */
    public static final double REST_RADIUS = 0.1;

    /** Time step (s). */
    public static final double TIME_STEP = 0.05;

    /**
     * A checked workload.
     *
     * @throws IllegalArgumentException if there are no bodies, or the restitution is not 0 to 1
     */
    public Workload {
        if (bodies < 1) {
            throw new IllegalArgumentException(
                    "a workload needs 1 or more bodies, but has " + bodies);
        }
        if (!(restitution >= 0 && restitution <= 1)) {
            throw new IllegalArgumentException(
                    "the restitution must be 0 to 1, but is " + restitution);
        }
    }

    /** Of so many bodies, with seed 1, restitution 1 and targets of their own. */
    public static Workload of(int bodies) {
        return new Workload(bodies, 1, 1, Targets.OWN);
    }

    /** The same with another restitution. */
    public Workload withRestitution(double other) {
        return new Workload(bodies, seed, other, targets);
    }

    /** The same with other targets. */
    public Workload withTargets(Targets other) {
        return new Workload(bodies, seed, restitution, other);
    }

    /** World time (s) over which it is measured: shorter where it is large. */
    public double duration() {
        return bodies >= 100_000 ? 10 : bodies >= 10_000 ? 30 : 120;
    }

    /** A world of it, for whoever wants to choose how it goes on; ids are 1 to n. */
    public WorldBuilder world() {
        WorldBuilder world = World.builder().timeStep(TIME_STEP);
        Sphere sphere = new Sphere(RADIUS);
        int[] number = {0};
        formation()
                .each(
                        (place, target) ->
                                world.add(
                                        WorldObjectDefinition.named("Sphere " + ++number[0])
                                                .volume(sphere)
                                                .mass(MASS)
                                                .restitution(restitution)
                                                .position(place)
                                                .effect(drive(target))
                                                .build()));
        return world;
    }

    /** Where the bodies start (m): x, y, z of body i at 3 i and behind. */
    public double[] positions() {
        double[] all = new double[3 * bodies];
        int[] at = {0};
        formation().each((place, _) -> put(place, all, at));
        return all;
    }

    /** Where the bodies are driven to (m), as {@link #positions}. */
    public double[] targetPoints() {
        double[] all = new double[3 * bodies];
        int[] at = {0};
        formation().each((_, target) -> put(target, all, at));
        return all;
    }

    private static void put(Vec3 v, double[] to, int[] at) {
        to[at[0]++] = v.x();
        to[at[0]++] = v.y();
        to[at[0]++] = v.z();
    }

    private Formation formation() {
        return new Formation(bodies, seed, targets);
    }

    private static CentralForce drive(Vec3 target) {
        return new CentralForce(FORCE, REST_RADIUS, target);
    }

    /** Kinetic and potential energy of a body (J), on average, in a world of this workload. */
    public double energy(World world) {
        double sum = 0;
        for (WorldObject object : world.objects()) {
            CentralForce drive = (CentralForce) object.effects().getFirst();
            double speed = object.velocity().norm();
            sum += MASS * speed * speed / 2 + drive.potentialEnergy(object.position());
        }
        return sum / bodies;
    }
}
