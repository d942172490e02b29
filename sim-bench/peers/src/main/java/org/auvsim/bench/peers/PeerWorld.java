package org.auvsim.bench.peers;

/**
 * A world of equal spheres in some engine: no friction, no gravity, no damping, no sleeping. All
 * vectors of a kind are in one array, x, y, z of sphere i at 3 i and behind.
 */
interface PeerWorld extends AutoCloseable {
    /** Writes the centres (m). */
    void positions(double[] to);

    /** Writes the velocities (m/s). */
    void velocities(double[] to);

    /** Moves on by {@code dt} (s) under these forces (N), which act during this step alone. */
    void step(double[] forces, double dt);

    @Override
    void close();
}
