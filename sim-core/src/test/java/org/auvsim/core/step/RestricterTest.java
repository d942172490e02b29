package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Numbers;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.HalfSpace;
import org.auvsim.core.volume.HeightMap;
import org.auvsim.core.volume.Volume;
import org.junit.jupiter.api.Test;

import java.util.List;

class RestricterTest {
    /** A volume of a radius that none of the engine's own has with a mass. */
    private record Strange(double boundingRadius) implements Volume {

        @Override
        public Mat3 inertia(double mass) {
            return Mat3.diagonal(mass, mass, mass);
        }

        @Override
        public boolean contains(Vec3 point) {
            return point.norm() <= boundingRadius;
        }
    }

    private static WorldObjectDefinition moving(String name, double radius, double speed) {
        return Scene.ball(name, radius).velocity(speed, 0, 0).build();
    }

    private static double restricted(WorldObjectDefinition... objects) {
        return new RadiusDistanceRestricter().restrict(Scene.of(objects), 1);
    }

    @Test
    void inFigureFiveOneTheStepIsAQuarter() {
        assertThat(restricted(moving("A", 0.5, 2), moving("B", 0.5, 2))).isEqualTo(0.25);
    }

    @Test
    void theStepOfOneObjectCarriesOnToTheNext() {
        assertThat(restricted(moving("A", 0.5, 2), moving("B", 0.5, 1))).isEqualTo(0.25);
        assertThat(restricted(moving("A", 0.5, 1), moving("B", 0.5, 2))).isEqualTo(0.25);
        assertThat(restricted(moving("A", 0.5, 2), moving("B", 0.5, 9))).isEqualTo(0.03125);
    }

    @Test
    void ofMoreObjectsThanAreIntegratedAtOnceTheQuickestDecides() {
        WorldObjectDefinition[] many = new WorldObjectDefinition[150];
        for (int i = 0; i < many.length; i++) {
            many[i] = moving("Ball " + i, 0.5, i == 140 ? 9 : 0.1);
        }

        assertThat(restricted(many)).isEqualTo(0.03125);
    }

    private static WorldObjectDefinition strange(String name, double radius, double speed) {
        return WorldObjectDefinition.named(name)
                .volume(new Strange(radius))
                .inertia(new Inertia(1, 1, 1, 0, 0, 0))
                .mass(1)
                .velocity(speed, 0, 0)
                .build();
    }

    @Test
    void aMovingObjectWithoutRadiusIsNamed() {
        assertThatThrownBy(() -> restricted(moving("A", 1, 0.1), strange("Dust", 0, 1)))
                .isInstanceOf(StepException.class)
                .hasMessageStartingWith(
                        "the time step cannot be made short enough for 'Dust' (id 2) at 0.0 s: in"
                                + " 1.0 s it still moves ")
                .hasMessageEndingWith(" m, more than its radius of 0.0 m");
    }

    @Test
    void aMovingObjectWithoutEndIsNamed() {
        double endless = Double.POSITIVE_INFINITY;

        assertThat(restricted(moving("A", 1, 0.1), strange("Pole", endless, 0))).isEqualTo(1);
        assertThatThrownBy(() -> restricted(moving("A", 1, 0.1), strange("Pole", endless, 1)))
                .isInstanceOf(StepException.class)
                .hasMessage(
                        "'Pole' (id 2) moves at 0.0 s, but has no radius to restrict the step by,"
                                + " as its volume has no end; make it fixed or choose the"
                                + " maximum-speed restricter");
    }

    @Test
    void groundAndSeaFloorRestrictNothing() {
        HeightMap.Row row = new HeightMap.Row(Numbers.of(-3, -4));
        WorldObjectDefinition ground =
                WorldObjectDefinition.named("Ground").fixed().volume(new HalfSpace()).build();
        WorldObjectDefinition floor =
                WorldObjectDefinition.named("Sea floor")
                        .fixed()
                        .volume(new HeightMap(2, List.of(row, row)))
                        .build();

        assertThat(restricted(ground, moving("A", 0.5, 2), floor)).isEqualTo(0.25);
        assertThat(new MaximumSpeedRestricter(4).restrict(Scene.of(ground, floor), 1)).isEqualTo(1);
    }

    @Test
    void moreThanSixtyHalvingsAreAnErrorThatNamesTheObject() {
        assertThat(restricted(moving("Quick", 0.5, 0.5 * 0x1p60))).isEqualTo(0x1p-60);
        assertThatThrownBy(() -> restricted(moving("Quick", 0.5, 0x1p60)))
                .isInstanceOf(StepException.class)
                .hasMessageContaining("'Quick' (id 1)");
    }

    @Test
    void theStatedSpeedGivesTheStepOfTheSmallestRadius() {
        Motion motion = Scene.of(moving("A", 0.5, 1), moving("B", 0.2, 1));

        assertThat(new MaximumSpeedRestricter(4).restrict(motion, 1)).isEqualTo(0.05);
    }

    @Test
    void whoMovesAtTheStatedSpeedKeepsIt() {
        for (double speed : new double[] {0.1, 0.3, 3, 7.7}) {
            Motion motion =
                    Scene.of(
                            Scene.ball("A", 0.7).position(100, 0, 0).velocity(speed, 0, 0).build());

            assertThat(new MaximumSpeedRestricter(speed).restrict(motion, 0.05)).isEqualTo(0.05);
        }
    }

    @Test
    void whoIsFasterThanTheStatedSpeedIsNamed() {
        Motion motion = Scene.of(moving("A", 0.5, 1), moving("Racer", 0.5, 5));

        assertThatThrownBy(() -> new MaximumSpeedRestricter(4).restrict(motion, 1))
                .isInstanceOf(StepException.class)
                .hasMessageContaining("'Racer' (id 2)")
                .hasMessageContaining("maximum speed of 4.0 m/s")
                .hasMessageContaining("state a higher speed");
    }

    @Test
    void theStatedSpeedMustBePositiveAndFinite() {
        for (double speed : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThatThrownBy(() -> new MaximumSpeedRestricter(speed))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("but is " + speed);
        }
    }
}
