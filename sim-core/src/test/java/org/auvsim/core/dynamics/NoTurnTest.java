package org.auvsim.core.dynamics;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.effect.CentralForce;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;

/** Bodies that do not turn are spared work, and nothing else is different. */
class NoTurnTest {
    /** Does nothing, but might turn a body: nothing is spared where it acts. */
    private record Nothing() implements BodyEffect {
        @Override
        public void add(Block block, int i) {}
    }

    private static List<WorldObjectDefinition> bodies(long seed) {
        Draws draws = new Draws(seed);
        List<WorldObjectDefinition> bodies = new ArrayList<>();
        for (int i = 0; i < 40; i++) {
            Vec3 v = draws.vector(2);
            WorldObjectDefinition.Builder body =
                    WorldObjectDefinition.named("body " + i)
                            .volume(new Box(draws.vector(0.5, 2)))
                            .mass(draws.number(1, 50))
                            .inertia(new Inertia(2, 3, 4, 0.1 * (i % 3), 0, -0.1 * (i % 3)))
                            .position(draws.vector(10))
                            .orientation(
                                    i % 4 == 0 ? new Quat(-0.0, 1, -0.0, 0) : draws.orientation())
                            .velocity(v.x(), -0.0, v.z())
                            .angularVelocity(0, -0.0, 0)
                            .force(NamedForce.direct("carried", Frame.BODY, draws.vector(5)));
            bodies.add((i % 10 == 9 ? body.fixed() : body).build());
        }
        return bodies;
    }

    private static Flight flight(long seed) {
        return Flight.of(bodies(seed))
                .with(new Gravity(9.81))
                .with(new CentralForce(10, 0.1, new Vec3(1, 2, 3)));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void theBitsAreThoseOfTheWholeComputation(long seed) {
        Flight spared = flight(seed);
        Flight whole = flight(seed).with(new Nothing());
        spared.advance(new Rk4(), 0.05, 50);
        whole.advance(new Rk4(), 0.05, 50);
        for (int i = 0; i < 40; i++) {
            assertThat(spared.body(i).movementState()).isEqualTo(whole.body(i).movementState());
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {4, 5})
    void oneThatTurnsAmongThemChangesNoneOfTheOthers(long seed) {
        List<WorldObjectDefinition> with = new ArrayList<>(bodies(seed));
        with.addAll(DrawnBodies.of(seed, 1));
        Flight spared = Flight.of(bodies(seed));
        Flight among = Flight.of(with);
        spared.advance(new Rk4(), 0.05, 50);
        among.advance(new Rk4(), 0.05, 50);
        for (int i = 0; i < 40; i++) {
            assertThat(spared.body(i).movementState()).isEqualTo(among.body(i).movementState());
        }
        assertThat(among.body(40).angularVelocity().norm()).isPositive();
    }
}
