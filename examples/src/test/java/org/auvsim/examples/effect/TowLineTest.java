package org.auvsim.examples.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldException;
import org.junit.jupiter.api.Test;

import java.io.InputStream;
import java.util.Optional;

class TowLineTest {
    private static WorldObjectDefinition.Builder buoy(long id, double x, double speed) {
        return WorldObjectDefinition.named("Buoy " + id)
                .id(id)
                .volume(new Sphere(0.5))
                .mass(2)
                .position(x, 0, 0)
                .velocity(speed, 0, 0);
    }

    /**
     * The stretch of a line between two masses, one of which is pulled by F, is that of one mass m
     * = mA mB / (mA + mB) on a spring: F m / (mA k) (1 - cos(t sqrt(k / m))).
     */
    @Test
    void aScenarioNamesTheLineAndTheBargeFollowsAsItsEquationSays() throws Exception {
        World world = load("tow.xml");
        double mass = 30.0 * 10 / (30 + 10);
        double frequency = Math.sqrt(40 / mass);
        for (int step = 0; step < 400; step++) {
            world.advanceTimestep();
            Vec3 tug = world.object("Tug").position();
            Vec3 barge = world.object("Barge").position();
            double stretch = 12 * mass / (30 * 40) * (1 - StrictMath.cos(frequency * world.time()));
            assertThat(tug.x() - barge.x()).isEqualTo(5 + stretch, within(1e-7));
        }
        Vec3 momentum = world.object("Barge").linearMomentum();
        assertThat(momentum.plus(world.object("Tug").linearMomentum()).x())
                .isEqualTo(12 * world.time(), within(1e-9));
    }

    @Test
    void aSlackLineDoesNothing() {
        World world =
                World.builder()
                        .add(buoy(1, 0, 0.3).effect(new TowLine(2, 4, 50)).build())
                        .add(buoy(2, 3, 0.2).build())
                        .build();
        for (int step = 0; step < 40; step++) {
            world.advanceTimestep();
        }
        assertThat(world.object(1).velocity()).isEqualTo(new Vec3(0.3, 0, 0));
        assertThat(world.object(2).velocity()).isEqualTo(new Vec3(0.2, 0, 0));
    }

    @Test
    void aLineToNobodyIsRefused() {
        World world = World.builder().build();
        assertThatThrownBy(() -> world.add(buoy(1, 0, 0).effect(new TowLine(7, 4, 50)).build()))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("Buoy 1")
                .hasMessageContaining("7");
    }

    @Test
    void aLineWithoutLengthOrStiffnessIsRefused() {
        assertThatThrownBy(() -> new TowLine(1, 0, 50))
                .hasMessage(
                        "a tow line needs a length above 0 m and a stiffness above 0 N/m, but has"
                                + " 0.0 m and 50.0 N/m");
        assertThatThrownBy(() -> new TowLine(1, 4, Double.NaN)).hasMessageContaining("NaN N/m");
    }

    private static World load(String name) throws Exception {
        try (InputStream in = TowLineTest.class.getResourceAsStream(name)) {
            byte[] text = Optional.ofNullable(in).orElseThrow().readAllBytes();
            return ScenarioLoader.load(TowLineTest.class.getClassLoader()).parse(text).world();
        }
    }
}
