package org.auvsim.core.step;

import org.auvsim.core.dynamics.EquationsOfMotion;
import org.auvsim.core.dynamics.ImpulseResponse;
import org.auvsim.core.dynamics.Rk4;
import org.auvsim.core.entity.Bodies;
import org.auvsim.core.entity.Collidable;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.PairQueries;
import org.auvsim.core.volume.Sphere;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Motions for tests of the stages of a step, without a world around them. */
final class Scene {
    private Scene() {}

    static Motion of(WorldObjectDefinition... objects) {
        return of(PairQueries.standard(), List.of(objects));
    }

    static Motion of(PairQueries queries, List<WorldObjectDefinition> objects) {
        Bodies bodies = new Bodies();
        List<Collidable> collidables = new ArrayList<>();
        for (int i = 0; i < objects.size(); i++) {
            collidables.add(bodies.add(i + 1, objects.get(i)));
        }
        return new Motion(
                bodies,
                collidables,
                new EquationsOfMotion(bodies.state(), List.of()),
                new Rk4(),
                queries,
                new ImpulseResponse(),
                /* asBoundingSpheres= */ false,
                Lanes.ONE,
                new StepTally(),
                new ContactMemory(),
                0);
    }

    /** Balls of 0.05 to 0.6 m at random in a cube of 6 m, some fixed, up to 5 m/s each way. */
    static Motion crowd(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        WorldObjectDefinition[] balls = new WorldObjectDefinition[random.nextInt(2, 60)];
        for (int i = 0; i < balls.length; i++) {
            WorldObjectDefinition.Builder ball =
                    ball("Ball " + i, random.nextDouble(0.05, 0.6))
                            .position(vector(random, 3))
                            .velocity(
                                    random.nextDouble(-5, 5),
                                    random.nextDouble(-5, 5),
                                    random.nextDouble(-5, 5));
            balls[i] = (i % 7 == 3 ? ball.fixed() : ball).build();
        }
        return of(balls);
    }

    static WorldObjectDefinition.Builder ball(String name, double radius) {
        return WorldObjectDefinition.named(name).volume(new Sphere(radius)).mass(1);
    }

    private static Vec3 vector(SplittableRandom random, double limit) {
        return new Vec3(
                random.nextDouble(-limit, limit),
                random.nextDouble(-limit, limit),
                random.nextDouble(-limit, limit));
    }

    /** Positions and radii of everything now: what no stage before the last may change. */
    static List<Vec3> positions(Motion motion) {
        List<Vec3> all = new ArrayList<>();
        for (int i = 0; i < motion.size(); i++) {
            all.add(motion.position(i, 0));
        }
        return all;
    }

    /** The sets that a partitioner makes, ready for a finder. */
    static CollisionSets partition(Motion motion, CollisionPartitioner partitioner, double dt) {
        CollisionSets sets = motion.sets();
        sets.begin(dt);
        partitioner.partition(motion, dt, sets);
        sets.close();
        return sets;
    }
}
