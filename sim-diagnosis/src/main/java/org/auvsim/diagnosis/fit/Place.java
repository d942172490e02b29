package org.auvsim.diagnosis.fit;

/** Where a descent has come to. */
record Place(Judged judged, Simulated at) {
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
}
