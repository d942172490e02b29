package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.viz.scene.Angles;
import org.auvsim.viz.scene.LiveClock;
import org.auvsim.viz.scene.Movement;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;
import org.junit.jupiter.api.Test;

class HistoryTest {
    private final Scene scene = new Scene(new LiveClock());

    HistoryTest() {
        scene.add(SeenObject.of(9, Scenes.buoy()));
    }

    @Test
    void whatIsSelectedLateShowsItsLastMinuteAtOnce() {
        for (int i = 0; i <= 1000; i++) {
            move(i * 0.5);
        }
        assertThat(history().times()).hasSize(121).startsWith(440).endsWith(500);
        assertThat(history().values(Quantity.DEPTH)).startsWith(440).endsWith(500);
        assertThat(history().values(Quantity.SPEED)).containsOnly(1);
    }

    @Test
    void whatIsStillToComeIsNotInIt() {
        move(0);
        move(1);
        scene.jumpTo(0.5);
        scene.look(0, look -> {});
        assertThat(history().times()).containsExactly(0, 0.5);
        assertThat(history().values(Quantity.DEPTH)).containsExactly(0, 0.5);
    }

    @Test
    void timeThatGoesBackBeginsAnew() {
        move(10);
        move(11);
        scene.jumpTo(3);
        move(3);
        assertThat(history().times()).containsExactly(3);
    }

    @Test
    void aYawThatPassesSternBreaksItsLine() {
        turned(1, Math.toRadians(179));
        turned(2, Math.toRadians(-179));
        scene.stepDone(2, 0);
        scene.look(Long.MAX_VALUE / 2, look -> {});
        assertThat(history().line(Quantity.YAW)[1]).isNaN();
        assertThat(history().values(Quantity.YAW)[1]).isCloseTo(-179, within(1e-9));
    }

    @Test
    void whatHardlyChangesIsALineInTheMiddleOfItsPlot() {
        sway(1, 5);
        sway(2, 5.0000001);
        double[] height = history().height(Quantity.X);
        assertThat(height[1] - height[0]).isCloseTo(0.0232, within(1e-6));
        assertThat((height[0] + height[1]) / 2).isCloseTo(5, within(1e-6));
    }

    @Test
    void whatChangesFillsTheHeightOfItsPlot() {
        sway(1, 5);
        sway(2, 7);
        double[] height = history().height(Quantity.X, Quantity.Y);
        // From y = 0 to x = 7, and a margin.
        assertThat(height[0]).isBetween(-1.0, 0.0);
        assertThat(height[1]).isBetween(7.0, 8.0);
    }

    private void sway(double time, double x) {
        scene.move(9, new Movement(time, new Vec3(x, 0, 0), Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO));
        scene.stepDone(time, 0);
        scene.look(Long.MAX_VALUE / 2, look -> {});
    }

    @Test
    void anglesAreAsPeopleSayThem() {
        Quat yaw = Quat.ofAxisAngle(new Vec3(0, 0, 1), 0.5);
        Quat bowUp = Quat.ofAxisAngle(new Vec3(0, 1, 0), -0.2);
        double[] angles = Angles.rollPitchYaw(yaw.times(bowUp));
        assertThat(angles[0]).isCloseTo(0, within(1e-12));
        assertThat(angles[1]).isCloseTo(0.2, within(1e-12));
        assertThat(angles[2]).isCloseTo(0.5, within(1e-12));
    }

    private History history() {
        return scene.lookAt(9, actor -> History.of(actor, scene.time())).orElseThrow();
    }

    /** Sinks by a metre a second. */
    private void move(double time) {
        Vec3 down = new Vec3(0, 0, -1);
        scene.move(9, new Movement(time, down.times(time), Quat.IDENTITY, down, Vec3.ZERO));
        scene.stepDone(time, 0);
        scene.look(Long.MAX_VALUE / 2, look -> {});
    }

    private void turned(double time, double yaw) {
        Quat turn = Quat.ofAxisAngle(new Vec3(0, 0, 1), yaw);
        scene.move(9, new Movement(time, Vec3.ZERO, turn, Vec3.ZERO, Vec3.ZERO));
    }
}
