package org.auvsim.core.entity;

import org.auvsim.core.math.Vec3;

import java.util.List;

/** The directions of motion that a mount leaves, 6 numbers each, orthonormal, in world axes. */
final class FreeDirections {
    private final double[][] directions;

    FreeDirections(Mount mount) {
        List<Vec3> along = mount.freeTranslations();
        List<Vec3> about = mount.freeRotations();
        directions = new double[along.size() + about.size()][6];
        for (int k = 0; k < along.size(); k++) {
            put(directions[k], 0, along.get(k));
        }
        for (int k = 0; k < about.size(); k++) {
            put(directions[along.size() + k], 3, about.get(k));
        }
    }

    private static void put(double[] direction, int at, Vec3 v) {
        direction[at] = v.x();
        direction[at + 1] = v.y();
        direction[at + 2] = v.z();
    }

    int count() {
        return directions.length;
    }

    double[] get(int k) {
        return directions[k];
    }

    /** Leaves of six numbers what is along these directions; the rest is exactly zero. */
    void keep(double[] s, int at, int scratch) {
        for (int c = 0; c < 6; c++) {
            s[scratch + c] = 0;
        }
        for (double[] direction : directions) {
            double along = along(direction, s, at);
            for (int c = 0; c < 6; c++) {
                s[scratch + c] += along * direction[c];
            }
        }
        System.arraycopy(s, scratch, s, at, 6);
    }

    /** Adds to the momenta of a body what of six numbers is along these directions. */
    void add(double[][] columns, int slot, double[] impulse, int at) {
        for (double[] direction : directions) {
            double along = along(direction, impulse, at);
            for (int c = 0; c < 6; c++) {
                columns[BodyState.PX + c][slot] += along * direction[c];
            }
        }
    }

    private static double along(double[] direction, double[] s, int at) {
        double sum = 0;
        for (int c = 0; c < 6; c++) {
            sum += direction[c] * s[at + c];
        }
        return sum;
    }
}
