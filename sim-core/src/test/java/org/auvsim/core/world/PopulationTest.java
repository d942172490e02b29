package org.auvsim.core.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Need;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;

import java.util.Optional;

class PopulationTest {
    private static WorldObjectDefinition ball(String name, long id) {
        return Balls.ball(name).id(id).position(9.0 * id, 0, 0).build();
    }

    @Test
    void whoStatesNoIdGetsTheLowestThatNobodyStates() {
        World world =
                World.builder()
                        .add(Balls.at("A", 0))
                        .add(ball("B", 1))
                        .add(Balls.at("C", 5))
                        .add(ball("D", 3))
                        .add(new UniformCurrent(2, "Drift", Vec3.ZERO))
                        .build();

        assertThat(world.object("A").id()).isEqualTo(4);
        assertThat(world.object("C").id()).isEqualTo(5);
        assertThat(world.objects())
                .extracting(WorldObject::name)
                .containsExactly("B", "D", "A", "C");
        assertThat(world.entities()).hasSize(5);
    }

    @Test
    void anIdIsUnique() {
        WorldBuilder builder = World.builder().add(ball("A", 47)).add(ball("B", 47));

        assertThatThrownBy(builder::build)
                .isInstanceOf(WorldException.class)
                .hasMessage("the id 47 of 'B' is taken by 'A'; ids are unique in a world");
    }

    @Test
    void aNameIsUniqueAmongAllEntities() {
        WorldBuilder builder =
                World.builder().add(new UniformCurrent(3, "A", Vec3.ZERO)).add(ball("A", 47));

        assertThatThrownBy(builder::build)
                .isInstanceOf(WorldException.class)
                .hasMessage("the name 'A' is taken by entity 3; names are unique in a world");
    }

    @Test
    void anIdIsPositive() {
        World world = World.builder().build();

        assertThatThrownBy(() -> world.add(new UniformCurrent(0, "Drift", Vec3.ZERO)))
                .isInstanceOf(WorldException.class)
                .hasMessage("the id of 'Drift' must be 1 or more, but is 0");
    }

    @Test
    void theIdOfWhoHasLeftIsNotUsedAgain() {
        World world = World.builder().add(ball("A", 1)).add(ball("B", 7)).build();
        world.remove(7);

        assertThat(world.add(Balls.at("C", 50)).id()).isEqualTo(8);
        assertThatThrownBy(() -> world.add(ball("D", 7)))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("ids are not used again");
        assertThatThrownBy(() -> world.copy().add(ball("D", 7))).isInstanceOf(WorldException.class);
        assertThat(world.add(ball("D", 4)).id()).isEqualTo(4);
        assertThat(world.add(ball("B", 9)).name()).isEqualTo("B");
    }

    @Test
    void anUnknownIdOrNameIsToldWithThoseThatThereAre() {
        World world = World.builder().add(ball("Rock", 88)).add(ball("Juggernaut", 47)).build();

        assertThatThrownBy(() -> world.object(5))
                .isInstanceOf(WorldException.class)
                .hasMessage("no world object has the id 5; there are 47 'Juggernaut', 88 'Rock'");
        assertThatThrownBy(() -> world.object("Rocc"))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("no world object has the name 'Rocc'");
        assertThatThrownBy(() -> world.remove(5))
                .isInstanceOf(WorldException.class)
                .hasMessage("no entity has the id 5");
        assertThatThrownBy(() -> World.builder().build().object(1))
                .hasMessage("no world object has the id 1; there are none");
    }

    @Test
    void aLongListOfObjectsIsCutShort() {
        WorldBuilder builder = World.builder();
        for (int i = 1; i <= 10; i++) {
            builder.add(ball("Ball " + i, i));
        }

        assertThatThrownBy(() -> builder.build().object(11))
                .hasMessageEndingWith("8 'Ball 8' and 2 more");
    }

    @Test
    void anUnlawfulStepOrStartIsRefused() {
        for (double step : new double[] {0, -0.05, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThatThrownBy(() -> World.builder().timeStep(step))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessage("the time step must be above 0 s and finite, but is %s s", step);
        }
        assertThatThrownBy(() -> World.builder().startTime(Double.NaN))
                .isInstanceOf(IllegalArgumentException.class);
        assertThat(World.builder().startTime(-5).build().time()).isEqualTo(-5);
    }

    @Test
    void aBodyOfAnotherWorldIsNotTakenOver() {
        WorldObject body = World.builder().add(ball("A", 1)).build().object(1);

        assertThatThrownBy(() -> World.builder().add(body).build())
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("add its definition instead");
    }

    /** A behavior that cannot do without a propulsor. */
    private record Cruise(String name) implements Behavior {
        @Override
        public Optional<Need> needs() {
            return Optional.of(Need.of(Propulsor.class));
        }

        @Override
        public void act(double time, WorldObject self) {}
    }

    @Test
    void whatLacksANeededComponentIsRefusedBeforeAnythingIsAdded() {
        World world = World.builder().add(ball("A", 1)).build();
        long before = world.stateHash();

        assertThatThrownBy(() -> world.add(Balls.ball("B").component(new Cruise("cruise")).build()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("component 'cruise' of 'B' needs a Propulsor; add one");

        assertThat(world.stateHash()).isEqualTo(before);
        world.advanceTimestep();
        assertThat(world.objects()).hasSize(1);
    }
}
