package org.auvsim.viz.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

class SceneTest {
    private static final long MILLIS = 1_000_000;

    private final Scene scene = new Scene(new LiveClock());

    SceneTest() {
        scene.add(
                SeenObject.of(
                        7,
                        WorldObjectDefinition.named("Ball")
                                .mass(1)
                                .volume(new Sphere(1))
                                .position(1, 0, 0)
                                .build()));
    }

    private static Movement at(double time, double x, double yaw) {
        return new Movement(
                time,
                new Vec3(x, 0, 0),
                Quat.ofAxisAngle(new Vec3(0, 0, 1), yaw),
                Vec3.ZERO,
                Vec3.ZERO);
    }

    private List<Double> seen(long nanos) {
        List<Double> values = new ArrayList<>();
        scene.look(
                nanos,
                look -> {
                    ActorView ball = look.actor(0);
                    values.add(look.time());
                    values.add(ball.position(0));
                    values.add(2 * Math.atan2(ball.orientation(3), ball.orientation(0)));
                });
        return values;
    }

    /** Steps of 0.05 s every 50 ms; the last one of them arrives at 150 ms. */
    private void steps() {
        for (int step = 1; step <= 3; step++) {
            scene.move(7, at(0.05 * step, step, 0.2 * step));
            scene.stepDone(0.05 * step, 50L * step * MILLIS);
        }
    }

    @Test
    void anObjectBeginsWhereItIsDescribed() {
        assertThat(seen(0).get(1)).isEqualTo(1);
    }

    @Test
    void betweenTwoMessagesTheStateLiesBetween() {
        steps();
        List<Double> half = seen(175 * MILLIS);
        assertThat(half.get(0)).isCloseTo(0.125, within(1e-9));
        assertThat(half.get(1)).isCloseTo(2.5, within(1e-9));
        assertThat(half.get(2)).isCloseTo(0.5, within(1e-3));
    }

    @Test
    void theTimeShownNeverPassesTheNewestStep() {
        steps();
        assertThat(seen(900 * MILLIS)).startsWith(3 * 0.05, 3.0);
    }

    @Test
    void theShorterWayRoundIsTaken() {
        scene.move(7, at(0.05, 0, 3));
        scene.stepDone(0.05, 50 * MILLIS);
        scene.move(7, at(0.1, 0, -3));
        scene.stepDone(0.1, 100 * MILLIS);
        assertThat(Math.abs(seen(125 * MILLIS).get(2))).isCloseTo(Math.PI, within(1e-9));
    }

    @Test
    void aStateOfTheSameTimeReplacesTheLast() {
        steps();
        scene.move(7, at(0.15, 9, 0));
        assertThat(seen(900 * MILLIS).get(1)).isEqualTo(9);
    }

    @Test
    void timeThatGoesBackBeginsAnew() {
        steps();
        scene.jumpTo(0.05);
        scene.move(7, at(0.05, -4, 0));
        assertThat(seen(160 * MILLIS)).startsWith(0.05, -4.0);
        scene.look(0, look -> assertThat(look.actor(0).trailLength()).isEqualTo(1));
    }

    @Test
    void aTrailIsBounded() {
        for (int step = 1; step <= 2 * Trail.MOST; step++) {
            scene.move(7, at(step, step, 0));
            scene.move(
                    7,
                    at(step + Trail.SECONDS / Trail.MOST / 2, -1, 0)); // too near to the one before
        }
        scene.look(
                0,
                look -> {
                    assertThat(look.actor(0).trailLength()).isEqualTo(Trail.MOST);
                    assertThat(look.actor(0).trail(0, 0)).isEqualTo(Trail.MOST + 1);
                    assertThat(look.actor(0).trail(Trail.MOST - 1, 0)).isEqualTo(2 * Trail.MOST);
                });
    }

    @Test
    void aMeasurementIsSeenForAWhileAndAProjectionUntilTheNextStepIsKnown() {
        steps();
        scene.measure(7, 0.1, new Vec3(5, 6, 7));
        scene.project(7, at(0.2, 4, 0));
        scene.look(
                900 * MILLIS,
                look -> {
                    assertThat(look.actor(0).isMeasured()).isTrue();
                    assertThat(look.actor(0).measuredPosition(2)).isEqualTo(7);
                    assertThat(look.actor(0).isProjected()).isTrue();
                    assertThat(look.actor(0).projectedPosition(0)).isEqualTo(4);
                });
        scene.move(7, at(0.2, 4, 0));
        scene.move(7, at(3, 4, 0));
        scene.stepDone(3, 2_000 * MILLIS);
        scene.look(
                9_000 * MILLIS,
                look -> {
                    assertThat(look.actor(0).isMeasured()).isFalse();
                    assertThat(look.actor(0).isProjected()).isFalse();
                });
    }

    /** World times are rounded sums, and the time shown is one between two of them. */
    @Test
    void theProjectionOfTheStepThatWasMadeStaysWhileTimeStands() {
        double time = 0;
        for (int step = 1; step <= 300; step++) {
            time += 0.01;
            scene.project(7, at(time, 4, 0));
            scene.move(7, at(time, 3, 0)); // feedback has corrected it
            scene.stepDone(time, step * MILLIS);
            scene.look(
                    900_000 * MILLIS,
                    look -> {
                        assertThat(look.actor(0).isProjected()).isTrue();
                        assertThat(look.actor(0).projectedPosition(0)).isEqualTo(4);
                    });
        }
    }

    /** Of steps of 0.02 s each second one is told, not the same ones of states and projections. */
    @Test
    void aProjectionStaysWhereItComesAStepApartFromTheState() {
        for (int step = 2; step <= 100; step++) {
            if (step % 2 == 0) {
                scene.move(7, at(0.02 * step, 3, 0));
            } else {
                scene.project(7, at(0.02 * step, 4, 0));
            }
            scene.stepDone(0.02 * step, 20L * step * MILLIS);
            boolean isAnnounced = step > 2;
            scene.look(
                    20L * step * MILLIS,
                    look -> assertThat(look.actor(0).isProjected()).isEqualTo(isAnnounced));
        }
    }

    @Test
    void onlyWhatComesOrLooksOtherwiseCountsAsAChange() {
        long before = scene.revision();
        steps();
        scene.add(scene.object(7).orElseThrow());
        assertThat(scene.revision()).isEqualTo(before);
        scene.remove(7);
        assertThat(scene.revision()).isGreaterThan(before);
        assertThat(scene.objects()).isEmpty();
    }
}
