package org.auvsim.core.volume;

import java.util.ArrayList;
import java.util.List;

/**
 * The pair queries that a world knows, found by the kinds of the two volumes in either order.
 *
 * <p>Immutable; a user's own volume comes with {@link #with}.
 */
public final class PairQueries {
    private record Entry<A extends Volume, B extends Volume>(
            Class<A> a, Class<B> b, PairQuery<A, B> query) {
        boolean answers(Volume first, Volume second) {
            return a.isInstance(first) && b.isInstance(second);
        }

        boolean overlap(Volume first, Pose poseFirst, Volume second, Pose poseSecond) {
            return query.overlap(a.cast(first), poseFirst, b.cast(second), poseSecond);
        }

        ContactPoint contact(Volume first, Pose poseFirst, Volume second, Pose poseSecond) {
            return query.contact(a.cast(first), poseFirst, b.cast(second), poseSecond);
        }
    }

    private static final PairQueries STANDARD =
            new PairQueries(List.of())
                    .with(Box.class, Box.class, new BoxBox())
                    .with(Sphere.class, Box.class, new SphereBox())
                    .with(Sphere.class, Sphere.class, new SphereSphere());

    private final List<Entry<?, ?>> entries;

    private PairQueries(List<Entry<?, ?>> entries) {
        this.entries = entries;
    }

    /** The queries for all volumes that sim-core has. */
    public static PairQueries standard() {
        return STANDARD;
    }

    /** These and one more, which comes before those already known. */
    public <A extends Volume, B extends Volume> PairQueries with(
            Class<A> a, Class<B> b, PairQuery<A, B> query) {
        List<Entry<?, ?>> more = new ArrayList<>();
        more.add(new Entry<>(a, b, query));
        more.addAll(entries);
        return new PairQueries(List.copyOf(more));
    }

    /**
     * Whether the two volumes share a point.
     *
     * @throws UnsupportedOperationException if no query knows the pair
     */
    public boolean overlap(Volume a, Pose poseA, Volume b, Pose poseB) {
        for (int i = 0; i < entries.size(); i++) {
            Entry<?, ?> entry = entries.get(i);
            if (entry.answers(a, b)) {
                return entry.overlap(a, poseA, b, poseB);
            }
            if (entry.answers(b, a)) {
                return entry.overlap(b, poseB, a, poseA);
            }
        }
        throw unsupported(a, b);
    }

    /**
     * The contact of two volumes that overlap or nearly touch; its normal leads from {@code b} to
     * {@code a}.
     *
     * @throws UnsupportedOperationException if no query knows the pair
     */
    public ContactPoint contact(Volume a, Pose poseA, Volume b, Pose poseB) {
        for (Entry<?, ?> entry : entries) {
            if (entry.answers(a, b)) {
                return entry.contact(a, poseA, b, poseB);
            }
            if (entry.answers(b, a)) {
                return entry.contact(b, poseB, a, poseA).flipped();
            }
        }
        throw unsupported(a, b);
    }

    private static UnsupportedOperationException unsupported(Volume a, Volume b) {
        return new UnsupportedOperationException(
                "no pair query knows how a "
                        + a.getClass().getSimpleName()
                        + " meets a "
                        + b.getClass().getSimpleName()
                        + "; register one with PairQueries.with");
    }
}
