package org.auvsim.core.field;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.Current;
import org.auvsim.core.math.Vec3;

import java.util.List;

/** What a current gives a block of bodies, beside what its values and their differences say. */
final class Flows {
    private Flows() {}

    /** A current that is only known by its values. */
    private record Plain(Current of) implements Current {
        @Override
        public long id() {
            return of.id();
        }

        @Override
        public String name() {
            return of.name();
        }

        @Override
        public Vec3 valueAt(Vec3 position, double time) {
            return of.valueAt(position, time);
        }

        @Override
        public double elevation(double x, double y, double time) {
            return of.elevation(x, y, time);
        }
    }

    /** A block with a body at each of these places. */
    static Block at(List<Vec3> places, double time) {
        Block block = new Block();
        block.take(0, places.size());
        block.time = time;
        for (int i = 0; i < places.size(); i++) {
            block.state[BodyState.X][i] = places.get(i).x();
            block.state[BodyState.Y][i] = places.get(i).y();
            block.state[BodyState.Z][i] = places.get(i).z();
        }
        return block;
    }

    /** Velocities, elevations and derivatives agree with those from differences of the values. */
    static void assertExact(Current current, List<Vec3> places, double time, double error) {
        Block actual = at(places, time);
        Block expected = at(places, time);
        current.prepared().addTo(actual);
        new Plain(current.prepared()).addTo(expected);
        for (int i = 0; i < places.size(); i++) {
            Vec3 place = places.get(i);
            assertThat(actual.waterVelocity(i).distance(current.valueAt(place, time)))
                    .as("velocity at %s", place)
                    .isLessThan(1e-14);
            assertThat(actual.elevation[i])
                    .isCloseTo(current.elevation(place.x(), place.y(), time), within(1e-14));
            assertSameAlone(current.prepared(), actual, i, at(places, time));
            for (int d = 0; d < actual.flow.length; d++) {
                assertThat(actual.flow[d][i])
                        .as("derivative %s at %s", d, place)
                        .isCloseTo(expected.flow[d][i], within(error));
            }
        }
    }

    /** What it gives one body alone is what it gives that one among others. */
    private static void assertSameAlone(Current current, Block among, int i, Block alone) {
        current.addTo(alone, i);
        assertThat(alone.waterVelocity(i).distance(among.waterVelocity(i))).isLessThan(1e-14);
        assertThat(alone.waterVelocity(i == 0 ? 1 : 0)).isEqualTo(Vec3.ZERO);
        for (int d = 0; d < among.flow.length; d++) {
            assertThat(alone.flow[d][i]).isCloseTo(among.flow[d][i], within(1e-6));
        }
    }

    /** The rate (1/s) at which the water at body {@code i} of the block would lose volume. */
    static double divergence(Block block, int i) {
        return block.flow[3][i] + block.flow[7][i] + block.flow[11][i];
    }
}
