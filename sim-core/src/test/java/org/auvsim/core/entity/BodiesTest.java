package org.auvsim.core.entity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.junit.jupiter.api.Test;

class BodiesTest {
    private final Bodies bodies = new Bodies();

    private WorldObject add(String name, double x) {
        return bodies.add(
                bodies.count() + 1,
                WorldObjectDefinition.named(name)
                        .volume(new Sphere(x))
                        .mass(x)
                        .position(x, 0, 0)
                        .velocity(0, x, 0)
                        .force(NamedForce.direct("push", Frame.WORLD, new Vec3(0, 0, x)))
                        .build());
    }

    @Test
    void objectsKeepTheirNumbersWhenOneBeforeThemLeaves() {
        for (int i = 1; i <= 40; i++) {
            add("body " + i, i);
        }
        bodies.remove(bodies.objects().get(9));
        assertThat(bodies.count()).isEqualTo(39);
        assertThat(bodies.state().count()).isEqualTo(39);
        for (int slot = 0; slot < 39; slot++) {
            WorldObject object = bodies.objects().get(slot);
            double x = slot < 9 ? slot + 1 : slot + 2;
            assertThat(object.slot()).isEqualTo(slot);
            assertThat(object.name()).isEqualTo("body " + (int) x);
            assertThat(object.position()).isEqualTo(new Vec3(x, 0, 0));
            assertThat(object.velocity()).isEqualTo(new Vec3(0, x, 0));
            assertThat(object.mass()).isEqualTo(x);
            assertThat(bodies.state().radius()[slot]).isEqualTo(x);
        }
    }

    @Test
    void aCopyIsEqualAndIndependent() {
        WorldObject original = add("body", 2);
        Bodies copy = bodies.copy();
        WorldObject copied = copy.objects().getFirst();
        assertThat(copied.id()).isEqualTo(original.id());
        assertThat(copied.movementState()).isEqualTo(original.movementState());
        assertThat(copied.forces()).isEqualTo(original.forces());
        MovementState before = original.movementState();
        copied.setPosition(new Vec3(9, 9, 9));
        copied.setVelocity(new Vec3(9, 9, 9));
        copied.removeForce("push");
        copied.add(new Propulsor("screw", 1, 0, Vec3.ZERO, new Vec3(1, 0, 0)));
        copy.remove(copied);
        assertThat(original.movementState()).isEqualTo(before);
        assertThat(original.forces()).hasSize(1);
        assertThat(original.components()).isEmpty();
        assertThat(bodies.count()).isEqualTo(1);
    }

    @Test
    void anObjectThatCannotBeMadeLeavesNothingBehind() {
        WorldObjectDefinition tooFast =
                WorldObjectDefinition.named("too fast")
                        .volume(new Sphere(1))
                        .mass(1e100)
                        .velocity(1e250, 0, 0)
                        .build();
        add("first", 1);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> bodies.add(2, tooFast))
                .withMessageStartingWith("linear momentum of 'too fast' must be finite, but is");
        assertThat(bodies.state().count()).isEqualTo(1);
        assertThat(add("second", 3).slot()).isEqualTo(1);
    }
}
