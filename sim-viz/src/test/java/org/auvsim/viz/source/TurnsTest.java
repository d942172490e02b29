package org.auvsim.viz.source;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.viz.scene.SeenObject;
import org.junit.jupiter.api.Test;

import java.util.HashSet;
import java.util.List;
import java.util.OptionalLong;
import java.util.Set;
import java.util.stream.LongStream;
import java.util.stream.Stream;

class TurnsTest {
    private final Turns turns = new Turns();

    private static SeenObject ball(long id) {
        return SeenObject.of(id, definition("Ball").build());
    }

    private static SeenObject vehicle(long id) {
        Propulsor aft = new Propulsor("Aft", 10, 0.2, Vec3.ZERO, new Vec3(1, 0, 0));
        return SeenObject.of(id, definition("Vehicle").component(aft).build());
    }

    private static WorldObjectDefinition.Builder definition(String name) {
        return WorldObjectDefinition.named(name).mass(2).volume(new Sphere(0.5));
    }

    private static List<SeenObject> balls(long count) {
        return LongStream.rangeClosed(1, count).mapToObj(TurnsTest::ball).toList();
    }

    @Test
    void allOfAFewHaveEachTurn() {
        assertThat(turns.next(balls(20), OptionalLong.empty())).hasSize(20);
    }

    @Test
    void ofAThousandEachHasATurnInTen() {
        List<SeenObject> all = balls(1000);
        Set<Long> seen = new HashSet<>();
        for (int i = 0; i < 10; i++) {
            seen.addAll(turns.next(all, OptionalLong.empty()));
        }
        assertThat(seen).hasSize(1000);
    }

    @Test
    void ofAHugeWorldAHundredHaveATurn() {
        assertThat(turns.next(balls(5000), OptionalLong.empty())).hasSize(100);
    }

    @Test
    void whatIsWatchedAndWhatIsDrivenHaveEachTurn() {
        List<SeenObject> all =
                Stream.concat(
                                balls(1000).stream(),
                                LongStream.rangeClosed(2001, 2040).mapToObj(TurnsTest::vehicle))
                        .toList();
        for (int i = 0; i < 12; i++) {
            assertThat(turns.next(all, OptionalLong.of(777)))
                    .contains(777L)
                    .containsAll(LongStream.rangeClosed(2001, 2040).boxed().toList())
                    .hasSize(100);
        }
    }

    @Test
    void ofAThousandVehiclesEachHasATurnInTwenty() {
        List<SeenObject> all =
                LongStream.rangeClosed(1, 1000).mapToObj(TurnsTest::vehicle).toList();
        Set<Long> seen = new HashSet<>();
        for (int i = 0; i < 20; i++) {
            seen.addAll(turns.next(all, OptionalLong.empty()));
        }
        assertThat(seen).hasSize(1000);
    }

    @Test
    void whatNeverMovesHasATurnOnlyWhileItIsWatched() {
        SeenObject wall = SeenObject.of(5, definition("Wall").fixed().build());
        assertThat(turns.next(List.of(wall), OptionalLong.empty())).isEmpty();
        assertThat(turns.next(List.of(wall), OptionalLong.of(5))).containsExactly(5L);
        assertThat(turns.next(List.of(wall), OptionalLong.of(6))).isEmpty();
    }
}
