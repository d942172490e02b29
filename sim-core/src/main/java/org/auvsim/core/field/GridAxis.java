package org.auvsim.core.field;

import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Numbers;

/** Where a place is among the ascending places of a grid's axis. */
final class GridAxis {
    private GridAxis() {}

    /** Refuses places that do not ascend or of which there are none. */
    static void requireAscending(String of, String axis, Numbers places) {
        if (places.size() == 0) {
            throw new IllegalArgumentException(
                    axis + " of " + of + " must have at least one place, but has none");
        }
        for (int i = 0; i < places.size(); i++) {
            Domain.finite(of, "place " + (i + 1) + " on " + axis, places.get(i), "m");
            if (i > 0 && places.get(i) <= places.get(i - 1)) {
                throw new IllegalArgumentException(
                        "the places on %s of %s must ascend, but %s m follows %s m"
                                .formatted(axis, of, places.get(i), places.get(i - 1)));
            }
        }
    }

    /** The cell that a place is in, or the one at the edge that it is beyond. */
    static int index(Numbers places, double place) {
        int low = 0;
        int high = Math.max(0, places.size() - 2);
        while (low < high) {
            int middle = (low + high + 1) >>> 1;
            if (places.get(middle) <= place) {
                low = middle;
            } else {
                high = middle - 1;
            }
        }
        return low;
    }

    /** How far through a cell a place is, 0 to 1. */
    static double share(Numbers places, int cell, double place) {
        if (places.size() == 1) {
            return 0;
        }
        double way = place - places.get(cell);
        return Math.min(1, Math.max(0, way / (places.get(cell + 1) - places.get(cell))));
    }

    /** How fast the share grows by metre; 0 beyond the edges. */
    static double slope(Numbers places, int cell, double place) {
        boolean isInside =
                places.size() > 1
                        && place >= places.get(0)
                        && place <= places.get(places.size() - 1);
        return isInside ? 1 / (places.get(cell + 1) - places.get(cell)) : 0;
    }
}
