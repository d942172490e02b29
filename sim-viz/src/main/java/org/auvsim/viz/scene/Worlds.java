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

    /** These have been told: another world, if nothing is among them of what could move before. */
    void enter(List<SeenObject> objects) {
        if (isLeft) {
            isLeft = false;
            List<SeenObject> free = before.stream().filter(object -> !object.isFixed()).toList();
            List<SeenObject> marks = free.isEmpty() ? before : free;
            boolean isSame =
                    objects.isEmpty() || marks.stream().anyMatch(mark -> isAmong(objects, mark));
            count += isSame ? 0 : 1;
        }
    }

    private static boolean isAmong(List<SeenObject> objects, SeenObject mark) {
        return objects.stream()
                .anyMatch(object -> object.id() == mark.id() && object.name().equals(mark.name()));
    }

    long count() {
        return count;
    }
}
