package org.auvsim.viz.window;

import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;

import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Lets go of a chosen object that has left the world or given its id to another one; takes it again
 * if the same comes back before anything else is chosen, as after a connection that broke.
 */
final class Choice {
    private final Scene scene;
    private final Supplier<OptionalLong> chosen;
    private final Consumer<OptionalLong> choose;
    private Optional<SeenObject> known = Optional.empty();
    private boolean isLost;

    Choice(Scene scene, Supplier<OptionalLong> chosen, Consumer<OptionalLong> choose) {
        this.scene = scene;
        this.chosen = chosen;
        this.choose = choose;
    }

    /** Looks what has become of it. */
    void refresh() {
        OptionalLong now = chosen.get();
        if (now.isPresent()) {
            keep(now.getAsLong());
        } else if (isLost) {
            known.filter(this::isThere).ifPresent(this::takeAgain);
        } else {
            known = Optional.empty();
        }
    }

    private void keep(long id) {
        Optional<SeenObject> there = scene.object(id);
        if (isLost) {
            known = Optional.empty(); // somebody has chosen anew, maybe another one of the same id
        }
        isLost =
                there.isEmpty() || known.filter(before -> isOther(before, there.get())).isPresent();
        if (isLost) {
            choose.accept(OptionalLong.empty());
        } else {
            known = there;
        }
    }

    private static boolean isOther(SeenObject before, SeenObject now) {
        return before.id() == now.id() && !before.name().equals(now.name());
    }

    private boolean isThere(SeenObject object) {
        return scene.object(object.id()).filter(now -> !isOther(object, now)).isPresent();
    }

    private void takeAgain(SeenObject object) {
        isLost = false;
        choose.accept(OptionalLong.of(object.id()));
    }
}
