package org.auvsim.core.reference;

import org.auvsim.core.math.Numbers;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.Capsule;
import org.auvsim.core.volume.Compound;
import org.auvsim.core.volume.HalfSpace;
import org.auvsim.core.volume.HeightMap;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;
import org.junit.jupiter.params.provider.Arguments;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;

/** Volumes to draw, each for the engine and for the reference. */
public enum Kind {
    SPHERE {
        @Override
        Drawn draw(SplittableRandom random) {
            double radius = random.nextDouble(0.1, 0.6);
            return Drawn.of(new Sphere(radius), new Part(0, 0, 0, radius));
        }
    },
    BOX {
        @Override
        Drawn draw(SplittableRandom random) {
            double x = random.nextDouble(0.1, 0.5);
            double y = random.nextDouble(0.1, 0.5);
            double z = random.nextDouble(0.1, 0.5);
            return Drawn.of(new Box(new Vec3(2 * x, 2 * y, 2 * z)), new Part(x, y, z, 0));
        }
    },
    CAPSULE {
        @Override
        Drawn draw(SplittableRandom random) {
            double radius = random.nextDouble(0.1, 0.4);
            double half = random.nextDouble(0.1, 0.6);
            return Drawn.of(new Capsule(radius, 2 * half), new Part(half, 0, 0, radius));
        }
    },
    COMPOUND {
        // Two equal parts on either side of the origin and one about it, each turned its own way.
        @Override
        Drawn draw(SplittableRandom random) {
            List<Kind> convex = List.of(SPHERE, BOX, CAPSULE);
            Drawn middle = convex.get(random.nextInt(3)).draw(random);
            Drawn side = convex.get(random.nextInt(3)).draw(random);
            Vec3 away = new Vec3(random.nextDouble(0.2, 0.6), random.nextDouble(0.4), 0);
            List<org.auvsim.core.volume.Part> engine = new ArrayList<>();
            List<Part> reference = new ArrayList<>();
            double reach = middle.reach();
            for (int i = -1; i <= 1; i++) {
                Drawn part = i == 0 ? middle : side;
                double[] q = DrawnPair.orientation(random);
                Vec3 place = away.times(i);
                engine.add(
                        new org.auvsim.core.volume.Part(
                                part.volume(), place, new Quat(q[0], q[1], q[2], q[3])));
                Part copy = part.solid().parts().getFirst().eroded(0);
                copy.inBody.set(place.x(), place.y(), place.z(), q);
                reference.add(copy);
                reach = Math.max(reach, place.norm() + part.reach());
            }
            return new Drawn(
                    new Compound(engine), new Union(List.copyOf(reference)), reach, Vec3.ZERO);
        }
    },
    HALF_SPACE {
        @Override
        Drawn draw(SplittableRandom random) {
            return new Drawn(new HalfSpace(), new Ground(0), 0, new Vec3(0, 0, 0));
        }

        @Override
        public boolean isGround() {
            return true;
        }
    },
    HEIGHT_MAP {
        @Override
        Drawn draw(SplittableRandom random) {
            double spacing = random.nextDouble(0.3, 0.8);
            double[][] heights = new double[5][6];
            List<HeightMap.Row> rows = new ArrayList<>();
            for (double[] row : heights) {
                for (int i = 0; i < row.length; i++) {
                    row[i] = random.nextDouble(0.6 * spacing);
                }
                rows.add(new HeightMap.Row(Numbers.of(row)));
            }
            return new Drawn(
                    new HeightMap(spacing, rows),
                    new Terrain(spacing, heights),
                    0,
                    new Vec3(2.5 * spacing, 2 * spacing, 0.3 * spacing));
        }

        @Override
        public boolean isGround() {
            return true;
        }
    };

    /**
     * One volume in both forms.
     *
     * @param reach how far it extends from its origin (m)
     * @param middle the point of it to aim at, in its own coordinates (m)
     */
    record Drawn(Volume volume, Solid solid, double reach, Vec3 middle) {
        static Drawn of(Volume volume, Part part) {
            return new Drawn(volume, Union.of(part), part.reach(), Vec3.ZERO);
        }
    }

    /** Each pair of kinds once, the scenery second. */
    public static Stream<Arguments> pairs() {
        List<Arguments> pairs = new ArrayList<>();
        for (Kind a : values()) {
            for (Kind b : values()) {
                if (!a.isGround() && a.compareTo(b) <= 0) {
                    pairs.add(Arguments.of(a, b));
                }
            }
        }
        return pairs.stream();
    }

    abstract Drawn draw(SplittableRandom random);

    /** Whether it is part of the scenery and never moves. */
    public boolean isGround() {
        return false;
    }
}
