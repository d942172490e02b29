package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.viz.scene.Movement;
import org.auvsim.viz.scene.Scene;
import org.junit.jupiter.api.Test;

class PlotTest {
    private final Scene scene = Scenes.withBuoy();

    @Test
    void whatHardlyChangesIsALineInTheMiddle() {
        move(1, 5.0000001);
        double[] height = new Plot("x (m)", Quantity.X).height(history());
        assertThat(height[1] - height[0]).isCloseTo(0.0232, within(1e-6));
        assertThat((height[0] + height[1]) / 2).isCloseTo(5, within(1e-6));
    }

    @Test
    void whatChangesFillsItsHeight() {
        move(1, 7);
        double[] height = new Plot("x, y (m)", Quantity.X, Quantity.Y).height(history());
        // From y = 0 to x = 7, and a margin.
        assertThat(height[0]).isBetween(-1.0, 0.0);
        assertThat(height[1]).isBetween(7.0, 8.0);
    }

    private void move(double time, double x) {
        scene.move(9, new Movement(time, new Vec3(x, 0, 0), Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO));
        scene.stepDone(time, 0);
        scene.look(Long.MAX_VALUE / 2, look -> {});
    }

    private History history() {
        return scene.lookAt(9, actor -> History.of(actor, scene.time())).orElseThrow();
    }
}
