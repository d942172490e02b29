// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp;

import org.auvsim.core.entity.Domain;

/** What tolerances the adaptive solvers take. */
final class Tolerance {
    /** Open Source Physics takes no smaller one. */
    private static final double LEAST = 1e-12;

    /** A step may end short by this share of it, as the solvers count. */
    private static final double MOST = 0.5;

    private Tolerance() {}

    /**
     * Refuses what is out of bounds.
     *
     * @throws IllegalArgumentException if it is not 1e-12 to 0.5
     */
    static void require(String of, double tolerance) {
        Domain.within(of, "tolerance", LEAST, MOST, tolerance, "");
    }
}
