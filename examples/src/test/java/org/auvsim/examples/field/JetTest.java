package org.auvsim.examples.field;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;

import java.io.InputStream;
import java.util.Optional;

class JetTest {
    private static final Jet JET = new Jet(1, "Sluice", new Vec3(0, 3, -5), new Vec3(0, 2, 0), 4);

    @Test
    void isFastOnItsLineAndFadesBesideIt() {
        assertThat(JET.valueAt(new Vec3(0, 77, -5), 0)).isEqualTo(new Vec3(0, 2, 0));
        assertThat(JET.valueAt(new Vec3(4, -9, -5), 0).y()).isEqualTo(2 / Math.E, within(1e-15));
        assertThat(JET.valueAt(new Vec3(0, 3, 1), 0).y())
                .isEqualTo(2 * StrictMath.exp(-2.25), within(1e-15));
    }

    /** m v' = a (u - v) on the line: v = u (1 - exp(-a t / m)). */
    @Test
    void aScenarioNamesItAndALeafDriftsAway() throws Exception {
        World world = load("sluice.xml");
        while (world.time() < 5) {
            world.advanceTimestep();
        }
        double speed = 0.8 * (1 - StrictMath.exp(-2 * world.time() / 4));
        assertThat(world.object("Leaf").velocity().x()).isEqualTo(speed, within(1e-9));
        assertThat(world.object("Bystander").velocity().norm()).isLessThan(1e-9);
    }

    @Test
    void aJetNeedsADirectionAndAWidth() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Jet(1, "j", Vec3.ZERO, Vec3.ZERO, 1))
                .withMessageContaining("the speed of jet 'j' must be above 0 m/s");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Jet(1, "j", Vec3.ZERO, new Vec3(1, 0, 0), 0))
                .withMessageContaining("the width of jet 'j' must be above 0 m");
    }

    private static World load(String name) throws Exception {
        try (InputStream in = JetTest.class.getResourceAsStream(name)) {
            byte[] text = Optional.ofNullable(in).orElseThrow().readAllBytes();
            return ScenarioLoader.load(JetTest.class.getClassLoader()).parse(text).world();
        }
    }
}
