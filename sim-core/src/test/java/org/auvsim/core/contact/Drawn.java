package org.auvsim.core.contact;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Vec3;

import java.util.Arrays;

/** Bodies with any symmetric positive definite 6x6 inertia, and contacts between them. */
final class Drawn {
    final ContactBodies bodies = new ContactBodies();
    final Contacts contacts = new Contacts();
    private final Draws draws;

    Drawn(long seed) {
        draws = new Draws(seed);
    }

    Drawn bodies(int count) {
        for (int i = 0; i < count; i++) {
            Vec3 origin = draws.vector(1);
            int body = bodies.add(origin.x(), origin.y(), origin.z());
            for (int s = 0; s < 6; s++) {
                bodies.v[6 * body + s] = draws.number(-3, 3);
            }
            response(body);
        }
        return this;
    }

    /** K = G G^T + a little. */
    private void response(int body) {
        double[][] g = new double[6][6];
        for (double[] line : g) {
            for (int s = 0; s < 6; s++) {
                line[s] = draws.number(-1, 1);
            }
        }
        for (int r = 0; r < 6; r++) {
            for (int c = 0; c < 6; c++) {
                double sum = r == c ? 0.05 : 0;
                for (int s = 0; s < 6; s++) {
                    sum += g[r][s] * g[c][s];
                }
                bodies.k[36 * body + 6 * r + c] = sum;
            }
        }
    }

    Drawn fixed() {
        bodies.add(0.1, 0.2, 0.3);
        return this;
    }

    Drawn contacts(int count, double mostFriction, double mostRestitution) {
        for (int i = 0; i < count; i++) {
            int a = (int) draws.number(0, bodies.count);
            int b = (a + 1 + (int) draws.number(0, bodies.count - 1)) % bodies.count;
            Vec3 p = draws.vector(1);
            Vec3 n = draws.direction();
            int c = contacts.add(a, b, p.x(), p.y(), p.z(), n.x(), n.y(), n.z());
            contacts.friction[c] = mostFriction == 0 ? 0 : draws.number(0, mostFriction);
            double e = mostRestitution == 0 ? 0 : draws.number(0, mostRestitution);
            bounce(c, e);
        }
        return this;
    }

    void bounce(int contact, double restitution) {
        contacts.target[contact] =
                Math.max(0, -restitution * contacts.separationSpeed(contact, bodies));
    }

    /** Momentum from speeds, by the inverse of K. */
    double[] momentum(int body, double[] v) {
        RealMatrix k = new Array2DRowRealMatrix(6, 6);
        double trace = 0;
        for (int r = 0; r < 6; r++) {
            for (int c = 0; c < 6; c++) {
                k.setEntry(r, c, bodies.k[36 * body + 6 * r + c]);
            }
            trace += k.getEntry(r, r);
        }
        if (trace == 0) {
            return new double[6];
        }
        double[] speeds = Arrays.copyOfRange(v, 6 * body, 6 * body + 6);
        return new CholeskyDecomposition(k, 1e-12, 1e-12)
                .getSolver()
                .solve(new ArrayRealVector(speeds))
                .toArray();
    }

    double energy(double[] v) {
        double energy = 0;
        for (int body = 0; body < bodies.count; body++) {
            double[] p = momentum(body, v);
            for (int s = 0; s < 6; s++) {
                energy += p[s] * v[6 * body + s] / 2;
            }
        }
        return energy;
    }
}
