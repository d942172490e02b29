package org.auvsim.viz.scene;

import java.util.List;

/** Counts the worlds that a scene shows, one after the other. Of the scene's monitor alone. */
final class Worlds {
    private List<SeenObject> before = List.of();
    private boolean isLeft;
    private long count;

    /** These are there now; all will be told anew. */
    void leave(List<SeenObject> objects) {
        if (!isLeft) {
            before = objects;
            isLeft = true;
        }
    }

    /**
     * These have been told: another world, if of what can move now most was not there before, or
     * nothing is left of what was.
     */
    void enter(List<SeenObject> objects) {
        if (isLeft) {
            isLeft = false;
            List<SeenObject> marks = marks(objects);
            long kept = marks.stream().filter(mark -> isAmong(before, mark)).count();
            boolean isSame = objects.isEmpty() || (kept > 0 && 2 * kept >= marks.size());
            count += isSame ? 0 : 1;
        }
    }

    /** What tells a world from others: what can move in it, or else all there is. */
    private static List<SeenObject> marks(List<SeenObject> objects) {
        List<SeenObject> free = objects.stream().filter(object -> !object.isFixed()).toList();
        return free.isEmpty() ? objects : free;
    }

    private static boolean isAmong(List<SeenObject> objects, SeenObject mark) {
        return objects.stream()
                .anyMatch(object -> object.id() == mark.id() && object.looksLike(mark));
    }

    long count() {
        return count;
    }
}
