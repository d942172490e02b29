package org.auvsim.core.volume;

/** The queries for all pairs of volumes of this package. */
final class StandardQueries {
    private StandardQueries() {}

    static PairQueries addedTo(PairQueries none) {
        return none.with(Capsule.class, HalfSpace.class, new SolidHalfSpace<>())
                .with(Box.class, HalfSpace.class, new SolidHalfSpace<>())
                .with(Sphere.class, HalfSpace.class, new SolidHalfSpace<>())
                .with(Capsule.class, Capsule.class, new SolidPair<>())
                .with(Sphere.class, Capsule.class, new SolidPair<>())
                .with(Capsule.class, Box.class, new SolidPair<>())
                .with(Box.class, Box.class, new BoxBox())
                .with(Sphere.class, Box.class, new SphereBox())
                .with(Sphere.class, Sphere.class, new SphereSphere());
    }
}
