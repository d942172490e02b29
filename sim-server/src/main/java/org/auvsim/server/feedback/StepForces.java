package org.auvsim.server.feedback;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.auvsim.core.world.WorldListener;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;

/** Forces that corrections let act during one step: in each half of it another one. */
final class StepForces {
    /** What the force is called while it acts. */
    private static final String NAME = "correction of this step";

    /** Share of a step that is too short to be made. */
    private static final double REST = 1e-9;

    private record Pair(Vec3 first, Vec3 second) {}

    private final Map<Long, Pair> byObject = new TreeMap<>();

    /** None. */
    StepForces() {}

    private StepForces(StepForces original) {
        byObject.putAll(original.byObject);
    }

    /** The same forces and these on an object, in place of those that it had. */
    StepForces with(long objectId, Vec3 firstHalf, Vec3 secondHalf) {
        StepForces more = new StepForces(this);
        more.byObject.put(objectId, new Pair(firstHalf, secondHalf));
        return more;
    }

    /**
     * Makes a step of at most {@code wanted} (s) with these forces. It ends early at a collision;
     * without forces it is the world's own step.
     */
    void advance(World world, double wanted) {
        if (byObject.isEmpty()) {
            world.advanceTimestep(wanted);
            return;
        }
        double end = world.time() + wanted;
        CollisionWatch watch = new CollisionWatch();
        world.addListener(watch);
        try {
            apply(world, Pair::first);
            double half = wanted / 2;
            world.advanceTimestep(half);
            goOn(world, end - half, wanted, watch);
            apply(world, Pair::second);
            goOn(world, end, wanted, watch);
        } finally {
            world.removeListener(watch);
            remove(world);
        }
    }

    private static void goOn(World world, double until, double wanted, CollisionWatch watch) {
        while (!watch.collided && until - world.time() > REST * wanted) {
            world.continueTimestep(until - world.time());
        }
    }

    private void apply(World world, Function<Pair, Vec3> half) {
        byObject.forEach(
                (id, pair) -> {
                    if (world.find(id).isPresent()) {
                        Vec3 force = half.apply(pair);
                        world.object(id).applyForce(NamedForce.direct(NAME, Frame.WORLD, force));
                    }
                });
    }

    private void remove(World world) {
        for (long id : byObject.keySet()) {
            if (world.find(id).isPresent()) {
                world.object(id).removeForce(NAME);
            }
        }
    }

    private static final class CollisionWatch implements WorldListener {
        private boolean collided;

        @Override
        public void happened(WorldEvent event) {
            collided |= event instanceof WorldEvent.Collided;
        }
    }
}
