package org.auvsim.core.step;

/**
 * The slip that is none. With contacts taken halfway through a segment, bodies that turn and do not
 * slip where they touch at the start seem to slip there, and as much the other way round at the
 * end: friction must not work against so much.
 */
final class TurningSlip {
    /** Numbers a contact: its place on the body (m), how the bodies slip there (m/s). */
    private static final int CONTACT = 6;

    private final ContactProblem problem;
    private final IslandTrial trial;
    private final IslandContacts contacts;
    private final ContactPlace place;

    /** The contacts where the segment starts. */
    private double[] noted = new double[CONTACT * 64];

    /** The first of each pair and, one past the last, their number. */
    private int[] from = new int[64];

    private final double[] slip = new double[3];

    TurningSlip(
            ContactProblem problem,
            IslandTrial trial,
            IslandContacts contacts,
            ContactPlace place) {
        this.problem = problem;
        this.trial = trial;
        this.contacts = contacts;
        this.place = place;
    }

    /** Notes where the contacts are as the segment starts, and how the bodies slip there. */
    void noteStart() {
        reserve();
        for (int k = 0; k < contacts.pairs(); k++) {
            from[k] = contacts.from(k);
        }
        from[contacts.pairs()] = contacts.count();
        for (int c = 0; c < contacts.count(); c++) {
            int at = CONTACT * c;
            place.find(c);
            noted[at] = place.x;
            noted[at + 1] = place.y;
            noted[at + 2] = place.z;
            problem.contacts.relativeVelocity(c, problem.bodies, noted, at + 3);
        }
    }

    private void reserve() {
        if (from.length <= contacts.pairs()) {
            from = new int[2 * contacts.pairs() + 1];
        }
        if (noted.length < CONTACT * contacts.count()) {
            noted = new double[2 * CONTACT * contacts.count()];
        }
    }

    /** Excuses the contacts, which have been found halfway, from the slip that is none. */
    void excuse() {
        trial.useStartVelocity();
        for (int k = 0; k < contacts.pairs(); k++) {
            for (int c = contacts.from(k); c < contacts.to(k); c++) {
                int start = nearest(k, c);
                if (start >= 0) {
                    excuse(c, start);
                }
            }
        }
    }

    private void excuse(int c, int start) {
        problem.contacts.relativeVelocity(c, problem.bodies, slip, 0);
        problem.contacts.slip(
                c,
                noted[start + 3] - slip[0],
                noted[start + 4] - slip[1],
                noted[start + 5] - slip[2]);
    }

    /** Where the contact of a pair is noted that was nearest to this one on the body; -1: none. */
    private int nearest(int k, int c) {
        place.find(c);
        int best = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int at = CONTACT * from[k]; at < CONTACT * from[k + 1]; at += CONTACT) {
            double dx = noted[at] - place.x;
            double dy = noted[at + 1] - place.y;
            double dz = noted[at + 2] - place.z;
            double squared = dx * dx + dy * dy + dz * dz;
            if (squared < least) {
                least = squared;
                best = at;
            }
        }
        return best;
    }
}
