package org.auvsim.core.actuator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.actuator.Screws.LAG;
import static org.auvsim.core.actuator.Screws.advance;
import static org.auvsim.core.actuator.Screws.body;
import static org.auvsim.core.actuator.Screws.screw;

import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BatteryTest {
    private static final double WATTS = 200;

    private static double charge(World world) {
        return body(world).component(Battery.class, "cells").orElseThrow().charge();
    }

    /** Simpson's rule of |level|^3, in steps that meet no command in their middle. */
    private static double quadrature(Lag course, double seconds) {
        int parts = 20_000;
        double sum = 0;
        for (int k = 0; k <= parts; k++) {
            double weight = k == 0 || k == parts ? 1 : k % 2 == 1 ? 4 : 2;
            sum += weight * Math.pow(Math.abs(course.level(Lag.left(LAG, seconds * k / parts))), 3);
        }
        return sum * seconds / parts / 3;
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "1, 0", "0.3, 0.9", "0.8, -1", "-0.6, 0.2", "0.5, 0.5", "-1, -0.1"})
    void theCubeOfALaggingLevelIsIntegratedInClosedForm(double from, double target) {
        Lag course = new Lag(from, target, LAG);
        for (double seconds : new double[] {0.01, 0.2, 0.7, 5}) {
            assertThat(course.cubeIntegral(seconds))
                    .isCloseTo(quadrature(course, seconds), within(1e-10));
        }
    }

    @Test
    void aBatteryCountsWhatIsDrawnThroughAllCommands() {
        World world = Screws.world(Screws.drawing(0, WATTS), new Battery("cells", 5000, 4000));
        double[] levels = {1, -0.7, 0.2};
        double reached = 0;
        double drawn = 0;
        for (double level : levels) {
            body(world).command(Propulsor.class, "screw", level);
            advance(world, 11);
            Lag course = new Lag(reached, level, LAG);
            drawn += WATTS * quadrature(course, 11 * 0.05);
            reached = course.level(Lag.left(LAG, 11 * 0.05));
        }
        body(world).behaviors().forEach(b -> b.act(world.time(), body(world)));

        assertThat(charge(world)).isCloseTo(4000 - drawn, within(1e-6));
    }

    @Test
    void whenItIsEmptyThePropulsorStopsWhateverIsCommanded() {
        World world = Screws.world(Screws.drawing(1, WATTS), new Battery("cells", 100, 100));

        advance(world, 10);
        assertThat(charge(world)).isCloseTo(100 - 9 * 0.05 * WATTS, within(1e-9));
        advance(world, 2);
        assertThat(charge(world)).isZero();
        double emptyAt = world.time() - 0.05;
        body(world).command(Propulsor.class, "screw", -1);
        advance(world, 400);

        assertThat(emptyAt).isCloseTo(0.55, within(1e-12));
        assertThat(screw(world).level()).isEqualTo(-1);
        assertThat(screw(world).levelAt(world.time())).isCloseTo(0, within(1e-15));
        double speed = body(world).velocity().x();
        advance(world, 10);
        assertThat(body(world).velocity().x()).isCloseTo(speed, within(1e-15));
    }

    @Test
    void whatAnObjectCannotDrawFromIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Screws.world(Screws.drawing(0, WATTS)))
                .withMessage(
                        "component 'screw' of 'body' needs a Battery 'cells', but there are [];"
                                + " correct the name or add it");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Battery("cells", 10, 11))
                .withMessage(
                        "the charge of battery 'cells' must be 0 to its capacity of 10.0 J, but is"
                                + " 11.0 J");
    }
}
