package org.auvsim.core.entity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.function.UnaryOperator;
import java.util.stream.Stream;

class WorldObjectDefinitionTest {
    private static final NamedForce PUSH =
            NamedForce.direct("push", Frame.WORLD, new Vec3(1, 0, 0));
    private static final Propulsor SCREW =
            new Propulsor("screw", 1, 0, Vec3.ZERO, new Vec3(1, 0, 0));

    private static WorldObjectDefinition.Builder ball() {
        return WorldObjectDefinition.named("ball").volume(new Sphere(1)).mass(5);
    }

    private static Arguments wrong(
            UnaryOperator<WorldObjectDefinition.Builder> change, String sentence) {
        return Arguments.of(sentence, change);
    }

    static Stream<Arguments> wrong() {
        return Stream.of(
                wrong(b -> b.id(0), "an id must be 1 or more, but is 0"),
                wrong(b -> b.mass(-3), "mass must be above 0 kg and finite, but is -3.0 kg"),
                wrong(b -> b.mass(0), "mass must be above 0 kg and finite, but is 0.0 kg"),
                wrong(b -> b.mass(Double.NaN), "mass must be above 0 kg and finite, but is NaN kg"),
                wrong(
                        b -> b.mass(Double.POSITIVE_INFINITY),
                        "mass must be above 0 kg and finite, but is Infinity kg"),
                wrong(b -> b.restitution(1.5), "restitution must be 0 to 1, but is 1.5"),
                wrong(b -> b.restitution(Double.NaN), "restitution must be 0 to 1, but is NaN"),
                wrong(b -> b.friction(-0.1), "friction must be 0 or more and finite, but is -0.1"),
                wrong(
                        b -> b.friction(Double.POSITIVE_INFINITY),
                        "friction must be 0 or more and finite, but is Infinity"),
                wrong(b -> b.layer(32), "a collision layer must be 0 to 31, but is 32"),
                wrong(b -> b.ignores(-1), "a collision layer must be 0 to 31, but is -1"),
                wrong(
                        b -> b.position(0, Double.NaN, 0),
                        "position and velocities of 'ball' must be finite numbers"),
                wrong(
                        b -> b.velocity(0, 0, Double.POSITIVE_INFINITY),
                        "position and velocities of 'ball' must be finite numbers"),
                wrong(
                        b -> b.force(PUSH).force(PUSH),
                        "world object 'ball' has two of the force name 'push'; each needs its own"),
                wrong(
                        b -> b.component(SCREW).component(SCREW),
                        "world object 'ball' has two of the component name 'screw'; each needs"
                                + " its own"),
                wrong(
                        b -> b.inertia(new Inertia(1, -1, 1, 0, 0, 0)),
                        "an inertia tensor must be finite and positive definite, but has xx = 1.0,"
                                + " yy = -1.0, zz = 1.0, xy = 0.0, xz = 0.0, yz = 0.0 kg m^2"),
                wrong(
                        b -> b.orientation(new Quat(0, 0, 0, 0)),
                        "an orientation needs a finite length above 0, but "
                                + new Quat(0, 0, 0, 0)
                                + " has 0.0"));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("wrong")
    void whatIsWrongIsSaidInASentence(
            String sentence, UnaryOperator<WorldObjectDefinition.Builder> change) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> change.apply(ball()).build())
                .withMessage(sentence);
    }

    @Test
    void whatIsMissingIsSaidInASentence() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> WorldObjectDefinition.named(" ").volume(new Sphere(1)).build())
                .withMessage("a world object needs a name that is not blank");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> WorldObjectDefinition.named("a").mass(1).build())
                .withMessage("world object 'a' needs a volume");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> WorldObjectDefinition.named("a").volume(new Sphere(1)).build())
                .withMessage("world object 'a' needs a mass, unless it is fixed");
    }

    @Test
    void theInertiaIsThatOfTheVolumeUnlessStated() {
        assertThat(ball().build().massProperties().orElseThrow().inertia())
                .isEqualTo(Mat3.diagonal(2, 2, 2));
        Inertia stated = new Inertia(3, 4, 5, 0.1, 0.2, 0.3);
        assertThat(ball().inertia(stated).build().massProperties().orElseThrow().inertia())
                .isEqualTo(new Mat3(3, 0.1, 0.2, 0.1, 4, 0.3, 0.2, 0.3, 5));
        WorldObjectDefinition rock =
                WorldObjectDefinition.named("rock").volume(new Sphere(1)).fixed().build();
        assertThat(rock.massProperties()).isEmpty();
    }

    @Test
    void anOrientationIsBroughtToLengthOne() {
        assertThat(ball().orientation(new Quat(0, 0, 3, 4)).build().orientation())
                .isEqualTo(new Quat(0, 0, 0.6, 0.8));
    }

    @Test
    void badForcesAndPropulsorsAreRefused() {
        Vec3 none = new Vec3(Double.NaN, 0, 0);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> NamedForce.direct("push", Frame.WORLD, none))
                .withMessageStartingWith("force 'push' must be finite, but is (NaN, 0.0, 0.0) N");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Propulsor("screw", -1, 0, Vec3.ZERO, new Vec3(1, 0, 0)))
                .withMessage(
                        "the maximum thrust of propulsor 'screw' must be 0 N or more and finite,"
                                + " but is -1.0 N");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Propulsor("screw", 1, 0, Vec3.ZERO, Vec3.ZERO));
        Propulsor astern = new Propulsor("screw", 10, -0.5, Vec3.ZERO, new Vec3(0, 3, 4));
        assertNear(astern.constantPush().orElseThrow().force(), new Vec3(0, -3, -4), 1e-14);
    }
}
