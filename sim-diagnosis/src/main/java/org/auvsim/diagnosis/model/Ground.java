package org.auvsim.diagnosis.model;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.core.entity.IgnoredLayer;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.step.EndOfStepFinder;
import org.auvsim.core.step.NoRestricter;
import org.auvsim.core.step.SnapshotStepper;
import org.auvsim.core.volume.PairQueries;
import org.auvsim.core.volume.Pose;
import org.auvsim.core.volume.Separation;
import org.auvsim.core.volume.Volume;
import org.auvsim.core.world.WorldBuilder;
import org.auvsim.server.feedback.RigidMotion;

import java.util.List;

/**
 * The fixed objects of a scenario that the body may touch, or is tied to. Variants of it are in a
 * layer of collisions of their own, which they ignore: they meet those objects, but not each other.
 *
 * @param layer of the variants
 */
record Ground(Scenario scenario, List<WorldObjectDefinition> objects, int layer) {
    /** So many variants at most share a world in which they touch something. */
    private static final int MOST_TOGETHER = 128;

    /** In a corner, what is moved out of one object may come into another, so often at most. */
    private static final int MOST_MOVES = 8;

    static Ground under(BelievedModel model) {
        WorldObjectDefinition body = model.variant().body();
        List<WorldObjectDefinition> fixed = new Company(model.scenario(), body).fixed();
        int layer = freeLayer(fixed);
        List<WorldObjectDefinition> objects =
                fixed.stream()
                        .map(o -> Company.meet(o, body) ? o : o.toBuilder().ignores(layer).build())
                        .toList();
        return new Ground(model.scenario(), objects, layer);
    }

    /** One that none of the objects is in or ignores; the first if there is none. */
    private static int freeLayer(List<WorldObjectDefinition> objects) {
        for (int layer = IgnoredLayer.LAST; layer > 0; layer--) {
            int it = layer;
            boolean isFree =
                    objects.stream()
                            .noneMatch(
                                    o ->
                                            o.layer() == it
                                                    || o.ignores().contains(new IgnoredLayer(it)));
            if (isFree) {
                return layer;
            }
        }
        return 0;
    }

    /** How many of so many variants may share a world: each looks at all others that are near. */
    int together(int variants) {
        return objects.isEmpty() ? Math.max(1, variants) : MOST_TOGETHER;
    }

    /** Puts the objects into a world, and lets it make steps as it needs for them. */
    void addTo(WorldBuilder world) {
        if (objects.isEmpty()) {
            world.stepper(
                    new SnapshotStepper(
                            new NoRestricter(), new NoCollisions(), new EndOfStepFinder()));
            return;
        }
        world.stepper(scenario.stepper());
        if (scenario.boundingSpheres()) {
            world.asBoundingSpheres();
        }
        objects.forEach(world::add);
    }

    /**
     * A motion that begins beside the objects: one that was measured in them, as noise may have it,
     * is moved out of them, the shortest way. Inside them nothing can be, and its way out would
     * take the engine very many parts of steps.
     */
    RigidMotion beside(Volume volume, RigidMotion motion) {
        RigidMotion beside = motion;
        boolean isIn = !objects.isEmpty();
        for (int move = 0; isIn && move < MOST_MOVES; move++) {
            isIn = false;
            for (WorldObjectDefinition object : objects) {
                Vec3 out = wayOut(volume, beside, object);
                if (!out.equals(Vec3.ZERO)) {
                    beside =
                            new RigidMotion(
                                    beside.position().plus(out),
                                    beside.orientation(),
                                    beside.velocity(),
                                    beside.angularVelocity());
                    isIn = true;
                }
            }
        }
        return beside;
    }

    /** The shortest way out of an object (m, world); none if it is not within. */
    private static Vec3 wayOut(Volume volume, RigidMotion motion, WorldObjectDefinition object) {
        Pose pose = Pose.of(motion.position(), motion.orientation());
        Pose ofObject = Pose.of(object.position(), object.orientation());
        if (areApart(volume, pose, object.volume(), ofObject)) {
            return Vec3.ZERO;
        }
        Separation to = new Separation();
        double gap = PairQueries.standard().distance(volume, pose, object.volume(), ofObject, to);
        return gap < 0 ? new Vec3(to.nx, to.ny, to.nz).times(-gap) : Vec3.ZERO;
    }

    /** Whether the boxes about two volumes are. */
    private static boolean areApart(Volume a, Pose poseA, Volume b, Pose poseB) {
        double[] boxes = new double[12];
        a.bounds(poseA, boxes, 0);
        b.bounds(poseB, boxes, 6);
        boolean areApart = false;
        for (int axis = 0; axis < 3; axis++) {
            areApart |= boxes[axis] > boxes[9 + axis] || boxes[6 + axis] > boxes[3 + axis];
        }
        return areApart;
    }

    /** A variant that touches the objects alone. */
    WorldObjectDefinition.Builder touching(WorldObjectDefinition.Builder variant) {
        return objects.isEmpty() ? variant : variant.layer(layer).ignores(layer);
    }
}
