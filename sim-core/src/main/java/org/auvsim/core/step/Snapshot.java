package org.auvsim.core.step;

import org.auvsim.core.entity.BodyState;

/** The state of all bodies at one instant, kept so that a step that fails can be undone. */
final class Snapshot {
    private final BodyState bodies;
    private final double[][] columns;
    private double time;

    Snapshot(BodyState bodies) {
        this.bodies = bodies;
        columns = new double[BodyState.COLUMNS][bodies.count()];
    }

    /** Keeps the present state, which is that of {@code now} (s). */
    void take(double now) {
        time = now;
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            System.arraycopy(bodies.column(c), 0, columns[c], 0, columns[c].length);
        }
    }

    /** Makes the kept state the present one again; returns its time (s). */
    double restore() {
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            System.arraycopy(columns[c], 0, bodies.column(c), 0, columns[c].length);
        }
        return time;
    }
}
