package org.auvsim.core.entity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;

class ExpandingSphereTest {
    /** Begins at 2 s with 0.5 m and grows by 4 m/s to 8.5 m, at 4 s. */
    private static final ExpandingSphere WAVE =
            ExpandingSphere.of(7, "Ping", new Vec3(1, 2, 3), 2, 0.5, 4, 8.5);

    private static ExpandingSphere other(long id) {
        return ExpandingSphere.of(id, "Wave " + id, Vec3.ZERO, 0, 1, 1, 2);
    }

    private static Contact meeting(long id) {
        Participant wave = new Participant(7, "Ping", ExpandingSphere.class, Optional.empty());
        Participant met = new Participant(id, "Other", ExpandingSphere.class, Optional.empty());
        return new Contact(3, Vec3.ZERO, new Vec3(0, 0, 1), wave, met);
    }

    /** The wave after the last of the changes, which has to be its own update. */
    private static ExpandingSphere updated(ExpandingSphere wave, List<Change> changes) {
        Change.Update<?> update = (Change.Update<?>) changes.getLast();
        assertThat(update.entityId()).isEqualTo(wave.id());
        return apply(update, wave);
    }

    private static <E extends Entity> ExpandingSphere apply(
            Change.Update<E> update, ExpandingSphere wave) {
        return (ExpandingSphere) update.update().apply(update.type().cast(wave));
    }

    @Test
    void itsFrontGrowsFromItsStartToItsEnd() {
        assertThat(WAVE.volumeAt(1)).isEqualTo(new Sphere(0.5));
        assertThat(WAVE.volumeAt(2)).isEqualTo(new Sphere(0.5));
        assertThat(WAVE.volumeAt(3)).isEqualTo(new Sphere(4.5));
        assertThat(WAVE.volumeAt(9)).isEqualTo(new Sphere(8.5));
        assertThat(WAVE.positionAt(3)).isEqualTo(new Vec3(1, 2, 3));
    }

    @Test
    void itIsOverWithItsGreatestRadius() {
        assertThat(WAVE.isOver(3.999)).isFalse();
        assertThat(WAVE.isOver(4)).isTrue();
    }

    @Test
    void itsSurfaceMovesWhileItGrows() {
        assertThat(WAVE.fastestSurface(0, 1.9)).isZero();
        assertThat(WAVE.fastestSurface(1, 2.1)).isEqualTo(4);
        assertThat(WAVE.fastestSurface(3.9, 5)).isEqualTo(4);
        assertThat(WAVE.fastestSurface(4, 5)).isZero();
    }

    @Test
    void itMeetsEachOneOnce() {
        List<Change> changes = WAVE.response().orElseThrow().respond(meeting(5));

        assertThat(changes).hasSize(1);
        ExpandingSphere after = updated(WAVE, changes);
        assertThat(WAVE.meets(other(5))).isTrue();
        assertThat(after.meets(other(5))).isFalse();
        assertThat(after.meets(other(6))).isTrue();
    }

    @Test
    void itsEffectComesBesideItsMemory() {
        Change removal = new Change.Remove(5);
        ExpandingSphere blast = WAVE.withEffect(contact -> List.of(removal));

        List<Change> changes = blast.response().orElseThrow().respond(meeting(5));

        assertThat(changes).hasSize(2).startsWith(removal);
        ExpandingSphere after = updated(blast, changes);
        assertThat(after.meets(other(5))).isFalse();
        assertThat(after.effect()).isEqualTo(blast.effect());
    }

    @Test
    void nonsenseIsRefusedByName() {
        assertThatThrownBy(() -> ExpandingSphere.of(1, "Ping", Vec3.ZERO, 0, 0, 4, 8))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("'Ping'")
                .hasMessageContaining("0.0 m");
        assertThatThrownBy(() -> ExpandingSphere.of(1, "Ping", Vec3.ZERO, 0, 9, 4, 8))
                .hasMessageContaining("greatest radius");
        assertThatThrownBy(() -> ExpandingSphere.of(1, "Ping", Vec3.ZERO, 0, 1, -4, 8))
                .hasMessageContaining("-4.0 m/s");
        assertThatThrownBy(() -> ExpandingSphere.of(1, "Ping", Vec3.ZERO, Double.NaN, 1, 4, 8))
                .hasMessageContaining("NaN s");
    }
}
