package org.auvsim.core.step;

/**
 * The speeds that an island's contacts are to have at least where a segment ends, given to the
 * solver as targets:
 *
 * <ul>
 *   <li>A gap that is not the margin is mended by a share a segment, with a slow end speed; what
 *       parts as the segment starts comes back as fast at most, so that its force does no work.
 *   <li>Half the margin is left at the end. As {@link GapForecast} tells, an end gap lacks nothing
 *       if the end speed of the trial is changed by 2 / h times what it lacks. Shapes are pushed
 *       apart no faster than they came, but for overlap.
 * </ul>
 *
 * <p>The faster of the two is the target.
 */
final class ContactAims {
    /** The share of a wrong gap that is mended in one segment. */
    private static final double MENDING = 0.2;

    /** Overlap is mended no faster than this many bounding radii a second. */
    private static final double FASTEST_MENDING = 0.5;

    /** The share of the margin that has to be left at a segment's end. */
    private static final double LEAST_GAP = 0.5;

    /**
     * Contacts that approach slower than this (m/s), such as the last frame's rest of error, need
     * no impulse at once: the forces mend it.
     */
    private static final double SLOW = 2e-6;

    /** Contacts that part slower than this (m/s) do so as gaps are mended. */
    private static final double SLOW_PARTING = 1e-4;

    private final ContactProblem problem;
    private final IslandContacts contacts;
    private final GapForecast gaps;

    ContactAims(ContactProblem problem, IslandContacts contacts, GapForecast gaps) {
        this.problem = problem;
        this.contacts = contacts;
        this.gaps = gaps;
    }

    /** The gap (m) that has to be left at a segment's end, where the margin is smallest. */
    double leastGap() {
        return LEAST_GAP * contacts.leastMargin();
    }

    /**
     * Asks of each contact that the bodies do not meet within {@code h} (s) at their present
     * speeds.
     *
     * @return whether any would
     */
    boolean aimAtStop(double h) {
        boolean any = false;
        for (int k = 0; k < contacts.pairs(); k++) {
            double margin = contacts.margin(k);
            for (int c = contacts.from(k); c < contacts.to(k); c++) {
                double target = Math.min(0, (margin - problem.gap(c)) / h);
                problem.contacts.target[c] = target;
                any |= contacts.speed(c) < target - SLOW;
            }
        }
        return any;
    }

    /** Sets the targets for the end of a trial over {@code h} (s), from what is foretold. */
    void aimAtEnd(double h) {
        for (int k = 0; k < contacts.pairs(); k++) {
            for (int c = contacts.from(k); c < contacts.to(k); c++) {
                double wanted = mendingSpeed(k, c, h) - gaps.bend(k);
                problem.contacts.target[c] = Math.max(wanted, openingSpeed(k, c, h));
            }
        }
    }

    /** The end speed (m/s) that mends a gap. */
    private double mendingSpeed(int k, int c, double h) {
        double missing = contacts.margin(k) - gaps.atStart(c);
        double wanted =
                missing < 0 ? missing / h : Math.min(MENDING * missing / h, fastestMending(k));
        double parting = gaps.speedAtStart(c);
        return parting > SLOW_PARTING ? Math.min(wanted, -parting) : wanted;
    }

    /** The end speed (m/s) with which enough of a gap is left; for shapes within bounds. */
    private double openingSpeed(int k, int c, double h) {
        double margin = contacts.margin(k);
        double lacking = LEAST_GAP * margin - gaps.atEnd(c);
        double opening = gaps.speedAtEnd(c) + 2 * lacking / h;
        if (contacts.areSpheres(k)) {
            return opening;
        }
        double missing = margin - gaps.atStart(c);
        double overlap = Math.max(0, missing - (1 - LEAST_GAP) * margin);
        double back = Math.max(0, -gaps.speedAtStart(c));
        double bound = back + Math.min(2 * overlap / h, fastestMending(k));
        return Math.min(opening, bound + 2 * gaps.bend(k));
    }

    private double fastestMending(int k) {
        return FASTEST_MENDING * contacts.smallerRadius(k);
    }
}
