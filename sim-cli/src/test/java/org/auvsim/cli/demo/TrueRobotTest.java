package org.auvsim.cli.demo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;

class TrueRobotTest {
    @Test
    void theFirstPushIsSlowedByTheWater() {
        TrueRobot robot = new TrueRobot(new FlightPlan());

        robot.moveTo(2);

        // 12 N on 30 kg would be 0.8 m in 2 s; the water takes some, the current gives little.
        Vec3 reached = robot.position();
        assertThat(reached.x()).isBetween(0.7, 0.8);
        assertThat(reached.y()).isBetween(0.0, 0.1);
    }

    @Test
    void theResultDoesNotDependOnHowOftenOneLooks() {
        TrueRobot often = new TrueRobot(new FlightPlan());
        TrueRobot once = new TrueRobot(new FlightPlan());

        for (int step = 1; step <= 400; step++) {
            often.moveTo(step * 0.05);
        }
        once.moveTo(20);

        assertThat(often.position().distance(once.position())).isEqualTo(0, within(1e-12));
    }
}
