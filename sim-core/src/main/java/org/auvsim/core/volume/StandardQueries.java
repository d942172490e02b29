package org.auvsim.core.volume;

import java.util.List;

/** The queries for all pairs of volumes of this package. */
final class StandardQueries {
    private static final List<Class<? extends Volume>> BOUNDED =
            List.of(Sphere.class, Capsule.class, Box.class, Compound.class);

    private StandardQueries() {}

    /** The queries given and these. */
    static PairQueries addedTo(PairQueries given) {
        PairQueries all = given;
        for (int i = 0; i < BOUNDED.size(); i++) {
            all = withFloors(all, BOUNDED.get(i));
            for (int j = i; j < BOUNDED.size(); j++) {
                all = withPair(all, BOUNDED.get(i), BOUNDED.get(j));
            }
        }
        return all.with(Box.class, Box.class, new BoxBox())
                .with(Sphere.class, Box.class, new SphereBox())
                .with(Sphere.class, Sphere.class, new SphereSphere());
    }

    private static <A extends Volume> PairQueries withFloors(PairQueries queries, Class<A> a) {
        return queries.with(a, HalfSpace.class, new SolidHalfSpace<>())
                .with(a, HeightMap.class, new SolidHeightMap<>());
    }

    private static <A extends Volume, B extends Volume> PairQueries withPair(
            PairQueries queries, Class<A> a, Class<B> b) {
        return queries.with(a, b, new SolidPair<>());
    }
}
