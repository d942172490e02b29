package org.auvsim.core.step;

import org.auvsim.core.entity.Collidable;
import org.auvsim.core.entity.CollisionResponse;
import org.auvsim.core.entity.Participant;
import org.auvsim.core.entity.RigidBody;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;

import java.util.List;
import java.util.Optional;

/**
 * All that may collide in a world, in order of id: which of them are bodies, who may meet whom, and
 * what each does then.
 */
final class Collidables {
    /** In place of the slot of what is no body. */
    private static final int NONE = -1;

    private final List<Collidable> all;
    private final int[] slots;
    private final boolean[] fixed;
    private final int[] layer;
    private final int[] ignored;
    private final CollisionResponse fallback;
    private final boolean asBoundingSpheres;

    /** These, of which those without a response of their own have {@code fallback}. */
    Collidables(List<Collidable> inOrder, CollisionResponse fallback, boolean asBoundingSpheres) {
        all = List.copyOf(inOrder);
        this.fallback = fallback;
        this.asBoundingSpheres = asBoundingSpheres;
        slots = new int[all.size()];
        fixed = new boolean[all.size()];
        layer = new int[all.size()];
        ignored = new int[all.size()];
        for (int i = 0; i < slots.length; i++) {
            slots[i] = NONE;
            if (all.get(i) instanceof RigidBody body) {
                slots[i] = body.slot();
                fixed[i] = body.isFixed();
                layer[i] = body.layer();
                ignored[i] = body.ignoredLayers();
            }
        }
    }

    int size() {
        return slots.length;
    }

    Collidable get(int i) {
        return all.get(i);
    }

    /** The number of the one with an id. */
    int indexOf(long id) {
        int i = 0;
        while (all.get(i).id() != id) {
            i++;
        }
        return i;
    }

    boolean isBody(int i) {
        return slots[i] != NONE;
    }

    /** The slot of a body. */
    int slot(int i) {
        return slots[i];
    }

    RigidBody body(int i) {
        return (RigidBody) all.get(i);
    }

    /** The slots of all bodies; a negative number for what is none. */
    int[] slots() {
        return slots;
    }

    boolean mayCollide(int i, int j) {
        if (isBody(i) && isBody(j)) {
            return !(fixed[i] && fixed[j])
                    && (ignored[i] >>> layer[j] & 1) == 0
                    && (ignored[j] >>> layer[i] & 1) == 0;
        }
        return (isBody(i) || isBody(j))
                && all.get(i).meets(all.get(j))
                && all.get(j).meets(all.get(i));
    }

    CollisionResponse response(int i) {
        return all.get(i).response().orElse(fallback);
    }

    Participant participant(int i) {
        Collidable c = all.get(i);
        return new Participant(
                c.id(),
                c.name(),
                c.getClass(),
                c instanceof RigidBody body ? Optional.of(body.motion()) : Optional.empty());
    }

    /** The volume as which it collides at a time (s). */
    Volume volumeAt(int i, double time) {
        Volume volume = all.get(i).volumeAt(time);
        return asBoundingSpheres ? new Sphere(volume.boundingRadius()) : volume;
    }
}
