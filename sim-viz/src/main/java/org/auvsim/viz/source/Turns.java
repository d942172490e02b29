package org.auvsim.viz.source;

import org.auvsim.core.actuator.Fin;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.viz.scene.SeenObject;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.OptionalLong;
import java.util.Set;

/**
 * Which objects are asked about next: what somebody does to an object, its description alone tells.
 * All of them have a turn, in bounded time.
 */
final class Turns {
    /** So many objects have a turn at once, */
    private static final int LEAST = 20;

    /** in a larger world this part of those that can move, */
    private static final int PART = 10;

    /** and never more than so many: to describe them takes a simulator about 0.1 s. */
    private static final int MOST = 100;

    private int drivenBefore;
    private int movingBefore;

    /** The one that is watched, then some that something is done to, then some others. */
    Set<Long> next(List<SeenObject> all, OptionalLong watched) {
        LinkedHashSet<Long> ids = new LinkedHashSet<>();
        all.stream()
                .filter(o -> watched.equals(OptionalLong.of(o.id())))
                .forEach(o -> ids.add(o.id()));
        List<SeenObject> moving = all.stream().filter(o -> !o.isFixed()).toList();
        List<SeenObject> driven =
                moving.stream()
                        .filter(o -> o.definition().filter(Turns::isDriven).isPresent())
                        .toList();
        int most = Math.clamp(moving.size() / PART, LEAST, MOST);
        drivenBefore = take(driven, drivenBefore, most / 2, ids);
        movingBefore = take(moving, movingBefore, most, ids);
        return ids;
    }

    /** Goes on around a list until there are so many ids; where it came to. */
    private static int take(List<SeenObject> ring, int before, int most, Set<Long> ids) {
        int at = before;
        for (int i = 0; i < ring.size() && ids.size() < most; i++) {
            at = (at + 1) % ring.size();
            ids.add(ring.get(at).id());
        }
        return at;
    }

    private static boolean isDriven(WorldObjectDefinition definition) {
        return !definition.force().isEmpty()
                || definition.component().stream()
                        .anyMatch(c -> c instanceof Propulsor || c instanceof Fin);
    }
}
