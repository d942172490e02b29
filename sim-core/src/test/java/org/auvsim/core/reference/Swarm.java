package org.auvsim.core.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Elastic balls on springs, solved exactly: closed-form motion between collisions, frictionless
 * impulses at them, one after the other. Nothing of the engine takes part.
 */
public final class Swarm {
    /**
     * A collision.
     *
     * @param depth how deep the two would have gone into each other (share of the lesser radius)
     */
    public record Meeting(double time, int first, int second, double depth) {}

    /** Two whose gap (m) is no wider have just bounced. */
    private static final double TOUCH = 1e-9;

    /** So often (s) it is asked whether they are apart again. */
    private static final double FINEST = 1e-6;

    private final int n;
    private final double[] radius;
    private final double[] mass;
    private final double[][] centre;
    private final double[][] place;
    private final double[][] speed;
    private final double[] since;
    private final double frequency;

    private Swarm(int n, double frequency) {
        this.n = n;
        this.frequency = frequency;
        radius = new double[n];
        mass = new double[n];
        centre = new double[n][3];
        place = new double[n][3];
        speed = new double[n][3];
        since = new double[n];
    }

    /** Balls on a cubic lattice, 1.5 m apart, with springs to points near its middle. */
    public static Swarm drawn(long seed, int n, double frequency) {
        SplittableRandom random = new SplittableRandom(seed);
        Swarm swarm = new Swarm(n, frequency);
        int side = (int) Math.ceil(Math.cbrt(n));
        for (int i = 0; i < n; i++) {
            swarm.radius[i] = random.nextDouble(0.3, 0.6);
            swarm.mass[i] = random.nextDouble(0.5, 2);
            int[] cell = {i % side, i / side % side, i / side / side};
            for (int axis = 0; axis < 3; axis++) {
                double middle = cell[axis] - (side - 1) / 2.0;
                swarm.place[i][axis] = 1.5 * middle + random.nextDouble(-0.05, 0.05);
                swarm.centre[i][axis] = 0.5 * middle + random.nextDouble(-0.3, 0.3);
                swarm.speed[i][axis] = random.nextDouble(-0.5, 0.5);
            }
        }
        return swarm;
    }

    /** The same with every place moved by up to {@code by} (m). */
    public Swarm shaken(double by, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Swarm shaken = new Swarm(n, frequency);
        System.arraycopy(radius, 0, shaken.radius, 0, n);
        System.arraycopy(mass, 0, shaken.mass, 0, n);
        for (int i = 0; i < n; i++) {
            for (int axis = 0; axis < 3; axis++) {
                shaken.place[i][axis] = place[i][axis] + random.nextDouble(-by, by);
                shaken.centre[i][axis] = centre[i][axis];
                shaken.speed[i][axis] = speed[i][axis];
            }
        }
        return shaken;
    }

    public int size() {
        return n;
    }

    public double radius(int i) {
        return radius[i];
    }

    public double mass(int i) {
        return mass[i];
    }

    /** Where the spring of ball {@code i} ends (m). */
    public double centre(int i, int axis) {
        return centre[i][axis];
    }

    /** Place (m) of ball {@code i} when it was last struck, or at the beginning. */
    public double place(int i, int axis) {
        return place[i][axis];
    }

    /** Velocity (m/s) then. */
    public double speed(int i, int axis) {
        return speed[i][axis];
    }

    /** Place (m) of ball {@code i} at a time not before the last collision (s). */
    public double placeAt(int i, int axis, double time) {
        return flight(i).at(time - since[i]).at[axis];
    }

    /** Goes through all collisions up to a time (s); call it once. */
    public List<Meeting> run(double end) {
        double[][] next = new double[n][n];
        for (int i = 0; i < n; i++) {
            predict(i, i + 1, next, 0, end);
        }
        List<Meeting> meetings = new ArrayList<>();
        while (true) {
            int a = 0;
            int b = 1;
            for (int i = 0; i < n; i++) {
                for (int j = i + 1; j < n; j++) {
                    if (next[i][j] < next[a][b]) {
                        a = i;
                        b = j;
                    }
                }
            }
            double time = next[a][b];
            if (time > end) {
                return meetings;
            }
            meetings.add(new Meeting(time, a, b, collide(a, b, time)));
            predict(a, 0, next, time, end);
            predict(b, 0, next, time, end);
        }
    }

    private Flight flight(int i) {
        return new Oscillation(centre[i], place[i], speed[i], frequency);
    }

    private void predict(int i, int from, double[][] next, double now, double end) {
        for (int j = from; j < n; j++) {
            if (j != i) {
                next[Math.min(i, j)][Math.max(i, j)] = meeting(i, j, now, end);
            }
        }
    }

    /** From {@code now}, at which a pair may just have parted, the next meeting of the two. */
    private double meeting(int i, int j, double now, double end) {
        Encounter encounter =
                new Encounter(
                        new Later(flight(i), now - since[i]),
                        Union.of(new Part(0, 0, 0, radius[i])),
                        new Later(flight(j), now - since[j]),
                        Union.of(new Part(0, 0, 0, radius[j])));
        double start = 0;
        while (encounter.gap(start) <= TOUCH) {
            start += FINEST;
            if (start > 1000 * FINEST) {
                throw new IllegalStateException(i + " and " + j + " stay in touch at " + now);
            }
        }
        return now + encounter.firstWithin(0, start, Math.max(start, end - now));
    }

    private double collide(int a, int b, double time) {
        double[] pa = hold(a, time);
        double[] pb = hold(b, time);
        double[] normal = new double[3];
        double reach = 0;
        double approach = 0;
        double square = 0;
        for (int axis = 0; axis < 3; axis++) {
            normal[axis] = pa[axis] - pb[axis];
            reach += normal[axis] * normal[axis];
        }
        reach = Math.sqrt(reach);
        for (int axis = 0; axis < 3; axis++) {
            double v = speed[a][axis] - speed[b][axis];
            normal[axis] /= reach;
            approach -= normal[axis] * v;
            square += v * v;
        }
        double impulse = 2 * approach / (1 / mass[a] + 1 / mass[b]);
        for (int axis = 0; axis < 3; axis++) {
            speed[a][axis] += impulse / mass[a] * normal[axis];
            speed[b][axis] -= impulse / mass[b] * normal[axis];
        }
        double sideways = Math.sqrt(Math.max(0, 1 - approach * approach / square));
        return reach * (1 - sideways) / Math.min(radius[a], radius[b]);
    }

    /** Begins the ball's motion anew where it is. */
    private double[] hold(int i, double time) {
        Flight flight = flight(i);
        double t = time - since[i];
        double[] where = flight.at(t).at.clone();
        double[] velocity = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            velocity[axis] = flight.velocity(axis, t);
        }
        place[i] = where;
        speed[i] = velocity;
        since[i] = time;
        return where;
    }

    /** A flight from a later instant on. */
    private record Later(Flight flight, double start) implements Flight {
        @Override
        public Placement at(double t) {
            return flight.at(start + t);
        }

        @Override
        public double velocity(int axis, double t) {
            return flight.velocity(axis, start + t);
        }

        @Override
        public double speedBound(double from, double to) {
            return flight.speedBound(start + from, start + to);
        }

        @Override
        public double spinBound() {
            return flight.spinBound();
        }
    }
}
