package org.auvsim.core.step;

import org.auvsim.core.dynamics.ImpulseResponse;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.CollisionResponse;
import org.auvsim.core.entity.RigidBody;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;

import java.util.List;

/** What the event stepper has to know of each body beside its motion: plain arrays, by slot. */
final class BodyTraits {
    final Volume[] volume;
    final boolean[] isSphere;
    final boolean areAllSpheres;

    /** A sphere about its centre of mass, free in all directions and without added mass. */
    final boolean[] isBall;

    final boolean[] isFixed;

    /** Whether it answers a collision by the impulse that the engine computes itself. */
    final boolean[] bounces;

    final double[] radius;
    final double[] restitution;
    final double[] friction;
    final int[] layer;
    final int[] ignored;

    /** Its place in the order of ids among all collidables. */
    final int[] rank;

    BodyTraits(
            BodyState state,
            List<WorldObject> bySlot,
            CollisionResponse fallback,
            boolean asBoundingSpheres) {
        int count = bySlot.size();
        volume = new Volume[count];
        isSphere = new boolean[count];
        isFixed = new boolean[count];
        isBall = new boolean[count];
        bounces = new boolean[count];
        radius = state.radius();
        restitution = new double[count];
        friction = new double[count];
        layer = new int[count];
        ignored = new int[count];
        rank = new int[count];
        boolean all = true;
        for (int slot = 0; slot < count; slot++) {
            RigidBody body = bySlot.get(slot);
            volume[slot] = asBoundingSpheres ? new Sphere(radius[slot]) : body.volume();
            isSphere[slot] = volume[slot] instanceof Sphere;
            isBall[slot] = isSphere[slot] && state.spatial(slot) == null;
            all &= isSphere[slot];
            isFixed[slot] = body.isFixed();
            bounces[slot] = body.response().orElse(fallback) instanceof ImpulseResponse;
            restitution[slot] = body.definition().restitution();
            friction[slot] = body.definition().friction();
            layer[slot] = body.layer();
            ignored[slot] = body.ignoredLayers();
        }
        areAllSpheres = all;
    }

    /** Notes each body's place among all that may collide. */
    void rank(Collidables all) {
        for (int i = 0; i < all.size(); i++) {
            if (all.isBody(i)) {
                rank[all.slot(i)] = i;
            }
        }
    }

    /** Whether the engine answers all collisions itself. */
    boolean allBounce() {
        for (boolean bounce : bounces) {
            if (!bounce) {
                return false;
            }
        }
        return true;
    }

    /** The gap (m) below which two bodies are near each other: twice what resting contacts keep. */
    double nearness(int a, int b) {
        return 2 * RestingContacts.MARGIN * Math.min(radius[a], radius[b]);
    }

    /** Whether a body is a ball without friction: no contact ever turns it. */
    boolean isPlainBall(int slot) {
        return isBall[slot] && friction[slot] == 0;
    }

    /** Whether the two are balls without friction between them: a collision does not turn them. */
    boolean arePlainBalls(int a, int b) {
        return isBall[a] && isBall[b] && friction[a] * friction[b] == 0;
    }

    /** Whether the engine answers a collision of the two, and no response of a user's own. */
    boolean bounce(int a, int b) {
        return bounces[a] && bounces[b];
    }

    boolean mayCollide(int a, int b) {
        return !(isFixed[a] && isFixed[b])
                && (ignored[a] >>> layer[b] & 1) == 0
                && (ignored[b] >>> layer[a] & 1) == 0;
    }
}
