package org.auvsim.server.feedback;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.Wrench;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.auvsim.core.world.WorldListener;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;

/** Forces and torques that corrections let act during one step: others in each half of it. */
final class StepForces {
    /** What they are called while they act: the force, and the two of a couple that turns. */
    private static final List<String> NAMES =
            List.of(
                    "correction of this step",
                    "turn of this step, one end",
                    "turn of this step, other end");

    /** Share of a step that is too short to be made. */
    private static final double REST = 1e-9;

    /** How many parts a step may have before it is given up; one that comes to rest has no end. */
    private static final int MOST_PARTS = 1000;

    private record Pair(Wrench first, Wrench second) {}

    private final Map<Long, Pair> byObject = new TreeMap<>();

    /** None. */
    StepForces() {}

    private StepForces(StepForces original) {
        byObject.putAll(original.byObject);
    }

    /**
     * The same and these on an object, in place of those that it had: force in the world's axes,
     * torque in the body's.
     */
    StepForces with(long objectId, Wrench firstHalf, Wrench secondHalf) {
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
        while (!watch.collided && isBefore(world, until, wanted)) {
            world.continueTimestep(until - world.time());
        }
    }

    /** Makes the whole of such a step, through all collisions; false if it does not end. */
    boolean complete(World world, double wanted) {
        double end = world.time() + wanted;
        advance(world, wanted);
        for (int part = 0; part < MOST_PARTS && isBefore(world, end, wanted); part++) {
            world.continueTimestep(end - world.time());
        }
        return !isBefore(world, end, wanted);
    }

    private static boolean isBefore(World world, double until, double wanted) {
        return until - world.time() > REST * wanted;
    }

    private void apply(World world, Function<Pair, Wrench> half) {
        byObject.forEach(
                (id, pair) -> {
                    if (world.find(id).isPresent()) {
                        apply(world.object(id), half.apply(pair));
                    }
                });
    }

    private static void apply(WorldObject object, Wrench wrench) {
        object.applyForce(NamedForce.direct(NAMES.get(0), Frame.WORLD, wrench.force()));
        Vec3 torque = wrench.torque();
        double size = torque.norm();
        if (size > 0) {
            Vec3 arm = across(torque.times(1 / size));
            Vec3 pull = torque.cross(arm).times(0.5);
            object.applyForce(new NamedForce(NAMES.get(1), Frame.BODY, pull, arm));
            object.applyForce(
                    new NamedForce(NAMES.get(2), Frame.BODY, pull.negated(), arm.negated()));
        } else {
            object.removeForce(NAMES.get(1));
            object.removeForce(NAMES.get(2));
        }
    }

    /** A direction at right angles to another one. */
    private static Vec3 across(Vec3 direction) {
        boolean isAlongX = Math.abs(direction.x()) > 0.6;
        Vec3 other = isAlongX ? new Vec3(0, 1, 0) : new Vec3(1, 0, 0);
        return direction.cross(other).normalized();
    }

    private void remove(World world) {
        for (long id : byObject.keySet()) {
            if (world.find(id).isPresent()) {
                NAMES.forEach(world.object(id)::removeForce);
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
