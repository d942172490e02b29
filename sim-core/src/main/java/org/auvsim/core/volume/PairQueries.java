package org.auvsim.core.volume;

import java.util.ArrayList;
import java.util.List;

/**
 * The pair queries that a world knows, found by the kinds of the two volumes in either order.
 *
 * <p>Immutable to those who use it; a user's own volume comes with {@link #with}.
 */
public final class PairQueries {
    private record Entry(
            Class<? extends Volume> a,
            Class<? extends Volume> b,
            PairQuery<? extends Volume, ? extends Volume> query) {
        boolean answers(Class<?> first, Class<?> second) {
            return a.isAssignableFrom(first) && b.isAssignableFrom(second);
        }
    }

    /**
     * The query for a pair of classes.
     *
     * @param flipped whether it takes the second volume first
     */
    private record Answer(
            Class<?> a, Class<?> b, PairQuery<Volume, Volume> query, boolean flipped) {}

    private static final PairQueries STANDARD = StandardQueries.addedTo(new PairQueries(List.of()));

    /** Places for answers; a power of 2, several times the number of pairs of kinds. */
    private static final int PLACES = 256;

    private final List<Entry> entries;

    /**
     * Answers found so far, each at its hash or behind. Threads may write the same place at once:
     * answers are immutable and those for the same pair are alike, so that whichever stays is
     * right.
     */
    private final Answer[] answers = new Answer[PLACES];

    private PairQueries(List<Entry> entries) {
        this.entries = entries;
    }

    /** The queries for all volumes that sim-core has. */
    public static PairQueries standard() {
        return STANDARD;
    }

    /** These and one more, which comes before those already known. */
    public <A extends Volume, B extends Volume> PairQueries with(
            Class<A> a, Class<B> b, PairQuery<A, B> query) {
        List<Entry> more = new ArrayList<>();
        more.add(new Entry(a, b, query));
        more.addAll(entries);
        return new PairQueries(List.copyOf(more));
    }

    /**
     * Whether the two volumes share a point.
     *
     * @throws UnsupportedOperationException if no query knows the pair
     */
    public boolean overlap(Volume a, Pose poseA, Volume b, Pose poseB) {
        Answer answer = answer(a, b);
        return answer.flipped
                ? answer.query.overlap(b, poseB, a, poseA)
                : answer.query.overlap(a, poseA, b, poseB);
    }

    /**
     * The contact of two volumes that overlap or nearly touch; its normal leads from {@code b} to
     * {@code a}.
     *
     * @throws UnsupportedOperationException if no query knows the pair
     */
    public ContactPoint contact(Volume a, Pose poseA, Volume b, Pose poseB) {
        Answer answer = answer(a, b);
        return answer.flipped
                ? answer.query.contact(b, poseB, a, poseA).flipped()
                : answer.query.contact(a, poseA, b, poseB);
    }

    /**
     * Measures the gap between the surfaces (m), as {@link PairQuery#distance}.
     *
     * @throws UnsupportedOperationException if no query knows the pair
     */
    public double distance(Volume a, Pose poseA, Volume b, Pose poseB, Separation to) {
        Answer answer = answer(a, b);
        if (!answer.flipped) {
            return answer.query.distance(a, poseA, b, poseB, to);
        }
        double distance = answer.query.distance(b, poseB, a, poseA, to);
        to.flip();
        return distance;
    }

    /**
     * Finds the points where the surfaces are no farther apart than the margin (m), as {@link
     * PairQuery#manifold}.
     *
     * @throws UnsupportedOperationException if no query knows the pair
     */
    public void manifold(Volume a, Pose poseA, Volume b, Pose poseB, double margin, Manifold to) {
        Answer answer = answer(a, b);
        if (answer.flipped) {
            answer.query.manifold(b, poseB, a, poseA, margin, to);
            to.flip();
        } else {
            answer.query.manifold(a, poseA, b, poseB, margin, to);
        }
    }

    private Answer answer(Volume a, Volume b) {
        Class<?> first = a.getClass();
        Class<?> second = b.getClass();
        int start = 31 * first.hashCode() + second.hashCode();
        for (int k = 0; k < PLACES; k++) {
            int place = (start + k) & (PLACES - 1);
            Answer known = answers[place];
            if (known == null) {
                known = find(a, b);
                answers[place] = known;
                return known;
            }
            if (known.a == first && known.b == second) {
                return known;
            }
        }
        return find(a, b);
    }

    private Answer find(Volume a, Volume b) {
        Class<?> first = a.getClass();
        Class<?> second = b.getClass();
        for (Entry entry : entries) {
            boolean straight = entry.answers(first, second);
            if (straight || entry.answers(second, first)) {
                // Safe: the classes of the two volumes are those that the query was registered for.
                @SuppressWarnings("unchecked")
                PairQuery<Volume, Volume> query = (PairQuery<Volume, Volume>) entry.query;
                return new Answer(first, second, query, !straight);
            }
        }
        throw unsupported(a, b);
    }

    private static UnsupportedOperationException unsupported(Volume a, Volume b) {
        String first = a.getClass().getSimpleName();
        String second = b.getClass().getSimpleName();
        if (!a.isBounded() && !b.isBounded()) {
            return new UnsupportedOperationException(
                    "a "
                            + first
                            + " and a "
                            + second
                            + " never meet: both go on for ever; make the objects fixed");
        }
        return new UnsupportedOperationException(
                "no pair query knows how a "
                        + first
                        + " meets a "
                        + second
                        + "; register one with PairQueries.with");
    }
}
