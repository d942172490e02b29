package org.auvsim.core.behavior;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.actuator.Battery;
import org.auvsim.core.actuator.Fin;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.behavior.ControlSurfaceSchedule.TimedAngle;
import org.auvsim.core.behavior.ForceSchedule.TimedForce;
import org.auvsim.core.behavior.PropulsorSchedule.TimedLevel;
import org.auvsim.core.entity.Bodies;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

class BehaviorTest {
    private static final Vec3 X = new Vec3(1, 0, 0);

    private final WorldObject self =
            new Bodies()
                    .add(
                            1,
                            WorldObjectDefinition.named("auv")
                                    .volume(new Sphere(1))
                                    .mass(1)
                                    .component(new Propulsor("screw", 10, 0, Vec3.ZERO, X))
                                    .build());

    private Vec3 forceNamed(String name) {
        return self.forces().stream()
                .filter(force -> force.name().equals(name))
                .map(NamedForce::vector)
                .findFirst()
                .orElse(Vec3.ZERO);
    }

    @Test
    void goToPointPushesTowardTheTargetUntilItIsNear() {
        GoToPoint home = new GoToPoint("home", 10, 0.1, new Vec3(4, 6, 3));
        self.setPosition(new Vec3(1, 2, 3));
        home.act(0, self);
        assertNear(forceNamed("home"), new Vec3(6, 8, 0), 1e-14);
        self.setPosition(new Vec3(4, 6, 2.95));
        home.act(1, self);
        assertThat(self.forces()).isEmpty();
        self.setPosition(new Vec3(4, 6, 2.85));
        home.act(2, self);
        assertNear(forceNamed("home"), new Vec3(0, 0, 10), 1e-14);
    }

    @Test
    void backAndForthPushesBackBeyondTheLimits() {
        BackAndForth patrol = new BackAndForth("patrol", 3, 5, new Vec3(0, 2, 0));
        self.setPosition(new Vec3(100, 5.1, 7));
        patrol.act(0, self);
        assertThat(forceNamed("patrol")).isEqualTo(new Vec3(-0.0, -3, -0.0));
        self.setPosition(new Vec3(100, 5, 7));
        patrol.act(1, self);
        assertThat(self.forces()).isEmpty();
        self.setPosition(new Vec3(100, -5.1, 7));
        patrol.act(2, self);
        assertThat(forceNamed("patrol")).isEqualTo(new Vec3(0, 3, 0));
    }

    @Test
    void aForceScheduleHoldsEachRowUntilTheNext() {
        ForceSchedule schedule =
                new ForceSchedule(
                        "tow",
                        Frame.BODY,
                        List.of(
                                new TimedForce(1, X, Vec3.ZERO),
                                new TimedForce(2, X.times(5), X),
                                new TimedForce(2, X.times(7), X)));
        schedule.act(0.99, self);
        assertThat(self.forces()).isEmpty();
        schedule.act(1, self);
        assertThat(self.forces()).containsExactly(new NamedForce("tow", Frame.BODY, X, Vec3.ZERO));
        schedule.act(1.99, self);
        assertThat(forceNamed("tow")).isEqualTo(X);
        schedule.act(100, self);
        assertThat(self.forces()).containsExactly(new NamedForce("tow", Frame.BODY, X.times(7), X));
    }

    @Test
    void aRowCountsAtItsTimeAlsoWhenTimeIsASumOfSteps() {
        double time = 0;
        for (int step = 0; step < 10; step++) {
            time += 0.1;
        }
        assertThat(time).isLessThan(1);
        new ForceSchedule("tow", Frame.WORLD, List.of(new TimedForce(1, X, Vec3.ZERO)))
                .act(time, self);
        assertThat(forceNamed("tow")).isEqualTo(X);
    }

    @Test
    void aPropulsorScheduleSetsTheLevel() {
        PropulsorSchedule schedule =
                new PropulsorSchedule(
                        "plan", "screw", List.of(new TimedLevel(0, 0.25), new TimedLevel(3, -1)));
        schedule.act(1, self);
        assertThat(self.components(Propulsor.class).getFirst().level()).isEqualTo(0.25);
        schedule.act(3, self);
        assertThat(self.components(Propulsor.class).getFirst().level()).isEqualTo(-1);
    }

    @Test
    void aBehaviorDirectsTheActuatorThatItNeeds() {
        Propulsor screw = self.components(Propulsor.class).getFirst();

        assertThat(new PropulsorSchedule("plan", "screw", List.of()).directs(screw)).isTrue();
        assertThat(new PropulsorSchedule("plan", "other", List.of()).directs(screw)).isFalse();
        assertThat(new ControlSurfaceSchedule("turn", "screw", List.of()).directs(screw)).isFalse();
        assertThat(new GoToPoint("home", 10, 0.1, X).directs(screw)).isFalse();
        assertThat(new Battery("cells", 9, 9).directs(screw)).isFalse();
    }

    @Test
    void aControlSurfaceScheduleTurnsTheFin() {
        self.add(
                new Fin(
                        "rudder",
                        0.01,
                        3,
                        Vec3.ZERO,
                        X,
                        new Vec3(0, 0, 1),
                        0,
                        0,
                        0.3,
                        1000,
                        0,
                        0,
                        0.2,
                        OptionalDouble.empty(),
                        Optional.empty()));
        ControlSurfaceSchedule schedule =
                new ControlSurfaceSchedule(
                        "turn", "rudder", List.of(new TimedAngle(0, 0.1), new TimedAngle(3, -0.2)));
        schedule.act(1, self);
        assertThat(self.components(Fin.class).getFirst().angle()).isEqualTo(0.1);
        schedule.act(3, self);
        assertThat(self.components(Fin.class).getFirst().angle()).isEqualTo(-0.2);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new TimedAngle(2, Double.NaN))
                .withMessage("the angle at 2.0 s must be finite, but is NaN rad");
    }

    @Test
    void badParametersAreRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new GoToPoint("home", -1, 0.1, X))
                .withMessage(
                        "force and radius of 'home' must be 0 or more, but are -1.0 N and 0.1 m");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new BackAndForth("patrol", 1, Double.NaN, X))
                .withMessage(
                        "force and limit of 'patrol' must be 0 or more, but are 1.0 N and NaN m");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new BackAndForth("patrol", 1, 1, Vec3.ZERO));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new TimedLevel(2, 1.5))
                .withMessage("the level at 2.0 s must be -1 to 1, but is 1.5");
        assertThatIllegalArgumentException()
                .isThrownBy(
                        () ->
                                new PropulsorSchedule(
                                        "plan",
                                        "screw",
                                        List.of(new TimedLevel(2, 1), new TimedLevel(1, 0))))
                .withMessage(
                        "rows of schedule 'plan' must be in order of time, but 1.0 s follows 2.0"
                                + " s");
    }
}
