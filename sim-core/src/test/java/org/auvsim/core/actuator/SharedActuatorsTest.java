package org.auvsim.core.actuator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.auvsim.core.actuator.Screws.advance;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.entity.Actuator;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;

/** What bodies carry alike pushes each of them as if it were the only one. */
class SharedActuatorsTest {
    private static final Vec3 PORT = new Vec3(-0.1, 0.05, 0.01);
    private static final Vec3 STARBOARD = new Vec3(-0.1, -0.05, 0.02);
    private static final Actuator ONE = thruster("port", PORT).commanded(0.9, 0);
    private static final Actuator OTHER = thruster("starboard", STARBOARD).commanded(-0.4, 0);
    private static final Actuator WEAKER = thruster("starboard", STARBOARD).commanded(-0.2, 0);
    private static final int STEPS = 30;

    /** Pushes as another does, but is asked for each body anew. */
    private record AskedAnew(Actuator actuator) implements Actuator {
        @Override
        public String name() {
            return actuator.name();
        }

        @Override
        public double command() {
            return actuator.command();
        }

        @Override
        public Actuator commanded(double command, double time) {
            return new AskedAnew(actuator.commanded(command, time));
        }

        @Override
        public void add(Block block, int i) {
            actuator.add(block, i);
        }
    }

    @Test
    void bodiesSideBySideMoveAsEachMovesAlone() {
        List<List<Actuator>> carried =
                List.of(
                        List.of(ONE, OTHER),
                        List.of(ONE, OTHER),
                        List.of(ONE, WEAKER),
                        List.of(),
                        List.of(ONE),
                        List.of(ONE, OTHER));
        World together = world(carried);
        advance(together, STEPS);
        for (int i = 0; i < carried.size(); i++) {
            World alone = world(List.of(carried.get(i)));
            advance(alone, STEPS);
            WorldObject expected = alone.object("body 0");
            WorldObject body = together.object("body " + i);
            assertThat(body.linearMomentum()).isEqualTo(expected.linearMomentum());
            assertThat(body.orientation()).isEqualTo(expected.orientation());
            assertThat(body.angularMomentum()).isEqualTo(expected.angularMomentum());
        }
    }

    @Test
    void whatIsTimedPushesAsWhatIsAskedForEachBody() {
        assertThat(ONE.isTimed()).isTrue();
        World timed = world(List.of(List.of(ONE, OTHER)));
        World asked = world(List.of(List.of(new AskedAnew(ONE), new AskedAnew(OTHER))));
        advance(timed, STEPS);
        advance(asked, STEPS);
        WorldObject body = timed.object("body 0");
        WorldObject same = asked.object("body 0");
        assertThat(body.angularMomentum().norm()).isGreaterThan(0.01);
        assertNear(same.position(), body.position(), 1e-12);
        assertNear(same.angularMomentum(), body.angularMomentum(), 1e-12);
    }

    private static World world(List<List<Actuator>> carried) {
        WorldBuilder world = World.builder().timeStep(0.05);
        for (int i = 0; i < carried.size(); i++) {
            WorldObjectDefinition.Builder body =
                    WorldObjectDefinition.named("body " + i)
                            .mass(5)
                            .volume(new Sphere(0.2))
                            .position(new Vec3(0, 0, 60 * i));
            carried.get(i).forEach(body::component);
            world.add(body.build());
        }
        return world.build();
    }

    private static Propulsor thruster(String name, Vec3 position) {
        return new Propulsor(
                name,
                12,
                0,
                position,
                new Vec3(0.6, 0.1, -0.2),
                Optional.empty(),
                0.4,
                0,
                -0.001,
                0,
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty());
    }
}
