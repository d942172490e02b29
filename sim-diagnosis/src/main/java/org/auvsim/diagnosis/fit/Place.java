package org.auvsim.diagnosis.fit;

/** Where a descent has come to. */
record Place(Judged judged, Simulated at) {
    /** A share of the cost that is not worth a step. */
    private static final double ENOUGH = 1e-4;

    static Place of(Fit fit) {
        Simulated at = Simulated.of(fit);
        return new Place(at.judged(), at);
    }

    /** The same of a fit that was judged. */
    static Place of(Judged judged) {
        return new Place(judged, Simulated.of(judged.fit()));
    }

    double cost() {
        return judged.cost();
    }

    /** Whether a step is worth making that gains so much. */
    boolean isWorthIt(double gain) {
        return gain > ENOUGH * cost();
    }
}
