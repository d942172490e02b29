package org.auvsim.experiments.hidden;

/** Frequencies of what comes again. */
final class Rhythm {
    private Rhythm() {}

    /** Of an oscillation of which a run shows one and a half periods or more (rad/s). */
    static double omega(Scene scene, Draws draws) {
        double slowest = Math.max(0.3, 2 * Math.PI * 1.5 / scene.duration());
        return draws.logBetween(slowest, Math.min(8, 6 * slowest));
    }
}
