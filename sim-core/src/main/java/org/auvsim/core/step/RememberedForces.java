package org.auvsim.core.step;

/**
 * The forces that an island's contacts had last: each contact starts from those of the nearest one
 * that is remembered of its pair, and what has been solved for is remembered.
 */
final class RememberedForces {
    /** Contacts within this share of the smaller radius of each other are held to be the same. */
    private static final double SAME = 0.05;

    private final ContactMemory memory;
    private final ContactProblem problem;
    private final IslandContacts contacts;
    private final ContactPlace place;

    /** What the world remembers of each pair. */
    private int[] entry = new int[64];

    RememberedForces(
            ContactMemory memory,
            ContactProblem problem,
            IslandContacts contacts,
            ContactPlace place) {
        this.memory = memory;
        this.problem = problem;
        this.contacts = contacts;
        this.place = place;
    }

    /** Finds what is remembered of the pairs at a time (s, world). */
    void find(double time) {
        if (entry.length < contacts.pairs()) {
            entry = new int[2 * contacts.pairs()];
        }
        // An entry that is made may move others: the second time none is.
        for (int round = 0; round < 2; round++) {
            for (int k = 0; k < contacts.pairs(); k++) {
                int a = contacts.first(k);
                int b = contacts.second(k);
                entry[k] = memory.entry(Math.min(a, b), Math.max(a, b), time);
            }
        }
    }

    /** Gives the contacts the remembered forces over {@code h} (s) for the solver's first guess. */
    void guess(double h) {
        for (int k = 0; k < contacts.pairs(); k++) {
            double within = SAME * contacts.smallerRadius(k);
            for (int c = contacts.from(k); c < contacts.to(k); c++) {
                place.find(c);
                int found = memory.nearest(entry[k], place.x, place.y, place.z, within);
                if (found < 0) {
                    problem.contacts.guess(c, 0, 0, 0, 0);
                } else {
                    guess(c, found, h, sign(k) * h);
                }
            }
        }
    }

    private void guess(int c, int found, double normal, double across) {
        problem.contacts.guess(
                c,
                normal * memory.force(found),
                across * memory.force(found + 1),
                across * memory.force(found + 2),
                across * memory.force(found + 3));
    }

    /** Remembers the contacts' impulses as forces over {@code h} (s). */
    void remember(double h) {
        for (int k = 0; k < contacts.pairs(); k++) {
            double across = sign(k) / h;
            memory.clearPoints(entry[k]);
            for (int c = contacts.from(k); c < contacts.to(k); c++) {
                place.find(c);
                memory.addPoint(
                        entry[k],
                        place.x,
                        place.y,
                        place.z,
                        problem.contacts.jn[c] / h,
                        across * problem.contacts.jx[c],
                        across * problem.contacts.jy[c],
                        across * problem.contacts.jz[c]);
            }
        }
    }

    /** Friction is remembered as it acts on the body with the lower slot. */
    private int sign(int pair) {
        return contacts.first(pair) < contacts.second(pair) ? 1 : -1;
    }
}
