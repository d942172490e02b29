package org.auvsim.viz.source;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.math.Vec3;
import org.auvsim.viz.scene.ActorView;
import org.auvsim.viz.scene.Meeting;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/** A recorded source as somebody at a window sees it, on a clock made by hand. */
final class Shown {
    private final RecordedSource source;
    private long nanos = 1_000_000_000L;

    Shown(RecordedSource source) {
        this.source = source;
    }

    /** The same place, but for rounding. */
    static void assertAt(Vec3 place, Vec3 expected) {
        assertThat(place.distance(expected))
                .as("%s is at %s", place, expected)
                .isCloseTo(0, within(1e-12));
    }

    Playback playback() {
        return source.playback().orElseThrow();
    }

    /** Shows a time (s). */
    Shown at(double time) {
        playback().seek(time);
        return after(0);
    }

    /** Lets seconds of the machine's clock pass. */
    Shown after(double seconds) {
        nanos += Math.round(seconds * 1e9);
        source.bring(nanos);
        return this;
    }

    /** The names of all that is there, in order of their coming. */
    List<String> names() {
        List<String> names = new ArrayList<>();
        source.scene()
                .look(
                        nanos,
                        look -> {
                            for (int i = 0; i < look.count(); i++) {
                                names.add(look.actor(i).object().name());
                            }
                        });
        return names;
    }

    List<Meeting> meetings() {
        List<Meeting> all = new ArrayList<>();
        source.scene().look(nanos, look -> all.addAll(look.meetings()));
        return all;
    }

    /** What is read of an object. */
    <T> T of(long id, Function<ActorView, T> reading) {
        List<T> read = new ArrayList<>();
        source.scene()
                .look(
                        nanos,
                        look -> {
                            for (int i = 0; i < look.count(); i++) {
                                if (look.actor(i).object().id() == id) {
                                    read.add(reading.apply(look.actor(i)));
                                }
                            }
                        });
        return read.getFirst();
    }

    List<NamedForce> forces(long id) {
        return of(id, ActorView::forces);
    }

    Vec3 place(long id) {
        return of(id, a -> new Vec3(a.position(0), a.position(1), a.position(2)));
    }

    /** Where it was measured to be, if that is shown. */
    Optional<Vec3> mark(long id) {
        return of(
                id,
                a ->
                        a.isMeasured()
                                ? Optional.of(
                                        new Vec3(
                                                a.measuredPosition(0),
                                                a.measuredPosition(1),
                                                a.measuredPosition(2)))
                                : Optional.empty());
    }
}
