package org.auvsim.viz.scene;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.volume.Sphere;
import org.junit.jupiter.api.Test;

import java.util.List;

class WorldsTest {
    private static final SeenObject BOB = object(1, "Bob", /* isFixed= */ false);
    private static final SeenObject CARL = object(1, "Carl", /* isFixed= */ false);
    private static final SeenObject ROCK = object(2, "Rock", /* isFixed= */ true);
    private final Worlds worlds = new Worlds();

    private static SeenObject object(long id, String name, boolean isFixed) {
        var definition = WorldObjectDefinition.named(name).mass(1).volume(new Sphere(1));
        return SeenObject.of(id, (isFixed ? definition.fixed() : definition).build());
    }

    @Test
    void whereSomethingIsStillThereTheWorldIsTheSame() {
        worlds.leave(List.of(BOB, ROCK));
        worlds.enter(List.of(BOB));
        assertThat(worlds.count()).isZero();
    }

    @Test
    void whereAllThatCouldMoveHasGoneTheWorldIsAnotherOne() {
        worlds.leave(List.of(BOB, ROCK));
        worlds.enter(List.of(CARL, ROCK));
        assertThat(worlds.count()).isEqualTo(1);
    }

    @Test
    void aConnectionThatBreaksAgainBeforeAllIsToldChangesNothing() {
        worlds.leave(List.of(BOB));
        worlds.leave(List.of());
        worlds.enter(List.of(BOB));
        assertThat(worlds.count()).isZero();
    }

    @Test
    void whatIsToldWithoutHavingBeenLeftIsNoOtherWorld() {
        worlds.enter(List.of(BOB));
        assertThat(worlds.count()).isZero();
    }
}
