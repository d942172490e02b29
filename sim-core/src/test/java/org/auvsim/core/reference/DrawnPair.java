package org.auvsim.core.reference;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Pose;
import org.auvsim.core.volume.Volume;
import org.auvsim.core.world.World;

import java.util.List;
import java.util.SplittableRandom;

/**
 * Two bodies under constant forces that turn freely and are aimed at each other, well enough for
 * about every second pair to meet; the second is fixed in a quarter of them. Drawn for the engine
 * and for the reference alike.
 */
public final class DrawnPair {
    /** How long they are followed (s). */
    public static final double END = 0.6;

    private static final double[] ZERO = {0, 0, 0};

    private final Kind.Drawn[] shapes;
    private final FreeFlight[] flights = new FreeFlight[2];
    private final WorldObjectDefinition[] definitions = new WorldObjectDefinition[2];

    private DrawnPair(Kind a, Kind b, SplittableRandom random) {
        shapes = new Kind.Drawn[] {a.draw(random), b.draw(random)};
        boolean fixed = b.isGround() || random.nextInt(4) == 0;
        double[] place = vector(random, 3);
        double[] velocity = fixed ? ZERO : vector(random, 1);
        double meeting = random.nextDouble(0.05, 0.5);
        double[] relative = vector(random, 4);
        double[] acceleration = vector(random, 5);
        double aim = b.isGround() ? 0.3 : 1.2 * (shapes[0].reach() + shapes[1].reach());
        double[] aside = vector(random, aim / Math.sqrt(3));
        double[] start = new double[3];
        for (int i = 0; i < 3; i++) {
            start[i] = place[i] + aside[i] - (relative[i] - velocity[i]) * meeting;
        }
        add(0, false, start, relative, acceleration, random);
        add(1, fixed, place, velocity, fixed ? ZERO : vector(random, 5), random);
    }

    /** The pair that belongs to a seed; the two are apart at first. */
    public static DrawnPair of(Kind a, Kind b, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        DrawnPair pair = new DrawnPair(a, b, random);
        while (pair.encounter(0).gap(0) < 0.01) {
            pair = new DrawnPair(a, b, random);
        }
        return pair;
    }

    private void add(
            int i,
            boolean fixed,
            double[] place,
            double[] velocity,
            double[] acceleration,
            SplittableRandom random) {
        double[] turn = orientation(random);
        Placement placement = new Placement();
        placement.set(0, 0, 0, turn);
        Vec3 middle = shapes[i].middle();
        double[] origin = new double[3];
        placement.outward(-middle.x(), -middle.y(), -middle.z(), origin, 0);
        for (int axis = 0; axis < 3; axis++) {
            origin[axis] += place[axis];
        }
        double[] spin = fixed ? ZERO : vector(random, 2);
        double mass = random.nextDouble(0.5, 2);
        double size = 0.2 * mass;
        double[] inertia = {
            size * random.nextDouble(1, 1.9),
            size * random.nextDouble(1, 1.9),
            size * random.nextDouble(1, 1.9)
        };
        flights[i] = new FreeFlight(origin, velocity, acceleration, inertia, turn, spin, END);
        WorldObjectDefinition.Builder builder =
                WorldObjectDefinition.named(i == 0 ? "A" : "B")
                        .volume(shapes[i].volume())
                        .position(origin[0], origin[1], origin[2])
                        .orientation(new Quat(turn[0], turn[1], turn[2], turn[3]))
                        .velocity(velocity[0], velocity[1], velocity[2])
                        .angularVelocity(spin[0], spin[1], spin[2]);
        if (fixed) {
            builder.fixed();
        } else {
            Vec3 force = new Vec3(acceleration[0], acceleration[1], acceleration[2]).times(mass);
            builder.mass(mass)
                    .inertia(new Inertia(inertia[0], inertia[1], inertia[2], 0, 0, 0))
                    .force(NamedForce.direct("Push", Frame.WORLD, force));
        }
        definitions[i] = builder.build();
    }

    private static double[] vector(SplittableRandom random, double size) {
        return new double[] {
            random.nextDouble(-size, size),
            random.nextDouble(-size, size),
            random.nextDouble(-size, size)
        };
    }

    static double[] orientation(SplittableRandom random) {
        double[] q = {
            random.nextDouble(-1, 1),
            random.nextDouble(-1, 1),
            random.nextDouble(-1, 1),
            random.nextDouble(-1, 1)
        };
        double norm = Math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        for (int i = 0; i < 4; i++) {
            q[i] /= norm;
        }
        return q;
    }

    /** What to put into a world. */
    public List<WorldObjectDefinition> definitions() {
        return List.of(definitions);
    }

    private Encounter encounter(double erosion) {
        return new Encounter(
                flights[0],
                shapes[0].solid().eroded(erosion),
                flights[1],
                shapes[1].solid().eroded(erosion));
    }

    /**
     * When two meet if each of their points may be off by some error.
     *
     * @param possible from when on they may be in contact (s); infinity for never
     * @param sure when they surely are (s); infinity for never
     */
    public record Meeting(double possible, double sure) {
        /** Whether they may meet at all. */
        public boolean isPossible() {
            return possible < Double.POSITIVE_INFINITY;
        }

        /** Whether they meet for certain. */
        public boolean isSure() {
            return sure < Double.POSITIVE_INFINITY;
        }
    }

    /** When they meet if each point of each body is where it should be to within an error (m). */
    public Meeting meeting(double error) {
        // Both are made smaller by the error; a corner of a box then goes back 1.73 times as far.
        Encounter encounter = encounter(error);
        double possible = encounter.firstWithin(5.5 * error, 0, END);
        return new Meeting(
                possible,
                possible < END
                        ? encounter.firstWithin(0, possible, END)
                        : Double.POSITIVE_INFINITY);
    }

    /** Gap (m) at an instant if it is below {@link Union#WIDE}, else a lower bound of it. */
    double gap(double t) {
        return encounter(0).gap(t);
    }

    /** Volume of the first (0) or second (1) body. */
    Volume volume(int i) {
        return shapes[i].volume();
    }

    /** Where it is at an instant. */
    Pose pose(int i, double t) {
        return flights[i].pose(t);
    }

    /** Whether the two go into each other by more than {@code depth} (m) in a world, now. */
    public boolean overlapIn(World world, double depth) {
        FreeFlight[] there = new FreeFlight[2];
        for (int i = 0; i < 2; i++) {
            WorldObject object = world.object(i == 0 ? "A" : "B");
            Vec3 p = object.position();
            Quat q = object.orientation();
            there[i] =
                    new FreeFlight(
                            new double[] {p.x(), p.y(), p.z()},
                            ZERO,
                            ZERO,
                            new double[] {1, 1, 1},
                            new double[] {q.w(), q.x(), q.y(), q.z()},
                            ZERO,
                            0);
        }
        return new Encounter(
                                there[0],
                                shapes[0].solid().eroded(depth / 2),
                                there[1],
                                shapes[1].solid().eroded(depth / 2))
                        .gap(0)
                <= 0;
    }

    /** How far (m) the first, which always moves, extends from its origin. */
    public double size() {
        return shapes[0].reach();
    }
}
