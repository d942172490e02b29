package org.auvsim.viz.source;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.viz.scene.Movement;

import java.util.Arrays;

/**
 * Where an object was, and how it was turned, in flat arrays. Velocities are differences of
 * neighbours: momenta do not tell them of a body that carries water with it.
 */
final class Track {
    private final Times times = new Times();
    private double[] places = new double[3 * 4];
    private float[] turns = new float[4 * 4];

    /**
     * Adds a state of a time (s) that is not before the others; one of the same time is replaced.
     */
    void add(double time, Vec3 place, Quat turn) {
        int i = times.add(time);
        if (3 * i >= places.length) {
            int length = Times.grown(i);
            places = Arrays.copyOf(places, 3 * length);
            turns = Arrays.copyOf(turns, 4 * length);
        }
        places[3 * i] = place.x();
        places[3 * i + 1] = place.y();
        places[3 * i + 2] = place.z();
        turns[4 * i] = (float) turn.w();
        turns[4 * i + 1] = (float) turn.x();
        turns[4 * i + 2] = (float) turn.y();
        turns[4 * i + 3] = (float) turn.z();
    }

    /** It has stood still until a time (s), if nothing is known of it since before that. */
    void rest(double until) {
        int last = times.count() - 1;
        if (last >= 0 && times.newest() < until) {
            add(until, place(last), turn(last));
        }
    }

    Times times() {
        return times;
    }

    void cut(double time) {
        times.cut(time);
    }

    /** Drops every second state. */
    void thin() {
        int count = times.count();
        times.thin();
        for (int k = 0; k < times.count(); k++) {
            int from = Times.kept(k, count);
            System.arraycopy(places, 3 * from, places, 3 * k, 3);
            System.arraycopy(turns, 4 * from, turns, 4 * k, 4);
        }
        places = Arrays.copyOf(places, 3 * (times.count() + 1));
        turns = Arrays.copyOf(turns, 4 * (times.count() + 1));
    }

    Vec3 place(int i) {
        return new Vec3(places[3 * i], places[3 * i + 1], places[3 * i + 2]);
    }

    Quat turn(int i) {
        return new Quat(turns[4 * i], turns[4 * i + 1], turns[4 * i + 2], turns[4 * i + 3]);
    }

    /** State {@code i}, moving as from the state before it to the one after it. */
    Movement motion(int i) {
        int a = Math.max(i - 1, 0);
        int b = Math.min(i + 1, times.count() - 1);
        double passed = times.get(b) - times.get(a);
        Vec3 velocity = passed > 0 ? place(b).minus(place(a)).times(1 / passed) : Vec3.ZERO;
        Vec3 spin = passed > 0 ? way(turn(a), turn(b)).times(1 / passed) : Vec3.ZERO;
        return new Movement(times.get(i), place(i), turn(i), velocity, spin);
    }

    /** The rotation vector (rad, world) of the shorter way from one orientation to another. */
    private static Vec3 way(Quat from, Quat to) {
        Quat turn = to.times(from.conjugate());
        Vec3 axis = new Vec3(turn.x(), turn.y(), turn.z());
        double sine = axis.norm();
        if (sine == 0) {
            return Vec3.ZERO;
        }
        double half = Math.atan2(sine, Math.abs(turn.w()));
        return axis.times(Math.copySign(2 * half / sine, turn.w()));
    }

    /** Where it was at a time (s); after the last state where it would have gone on to. */
    Vec3 placeAt(double time) {
        int i = Math.max(times.at(time), 0);
        double passed = time - times.get(i);
        if (passed <= 0) {
            return place(i);
        }
        int a = i + 1 < times.count() ? i : Math.max(i - 1, 0);
        int b = Math.min(a + 1, times.count() - 1);
        double length = times.get(b) - times.get(a);
        return length > 0
                ? place(i).plus(place(b).minus(place(a)).times(passed / length))
                : place(i);
    }

    /** How it was turned at the last state that is not after a time (s). */
    Quat turnAt(double time) {
        return turn(Math.max(times.at(time), 0)).normalized();
    }
}
