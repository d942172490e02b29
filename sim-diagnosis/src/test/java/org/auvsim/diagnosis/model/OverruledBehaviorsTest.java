package org.auvsim.diagnosis.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.run.ScheduledForce;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.List;

/**
 * A box of 2 kg in space. By the scenario one schedule drives it ahead, one aside and one up, with
 * 10 N each, for the 2 s that a run takes.
 */
class OverruledBehaviorsTest {
    private static final String MODEL =
            """
            <scenario><time-step delta="0.1"/>
              <world-object name="box" mass="2"><box><size x="1" y="1" z="1"/></box>
                <propulsor name="ahead" maximum-thrust="10"/>
                <propulsor name="aside" maximum-thrust="10"><direction x="0" y="1" z="0"/></propulsor>
                <force name="lift"><vector x="0" y="0" z="0"/></force>
                <propulsor-schedule name="ahead plan" propulsor="ahead">
                  <timed-level at="0" level="1"/>
                </propulsor-schedule>
                <propulsor-schedule name="aside plan" propulsor="aside">
                  <timed-level at="0" level="1"/>
                </propulsor-schedule>
                <force-schedule name="lift"><timed-force at="0"><vector x="0" y="0" z="10"/></timed-force>
                </force-schedule>
              </world-object></scenario>
            """;

    private static final RigidMotion AT_REST =
            new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);

    /** 10 N on 2 kg for 2 s. */
    private static final double FULL = 10;

    private static MeasuredRunBuilder told(String... commands) {
        MeasuredRunBuilder run = MeasuredRun.named("run").commands(List.of(commands));
        for (int k = 0; k <= 20; k++) {
            run.at(0.1 * k).position(0, 0, 0);
            for (int c = 0; c < commands.length; c++) {
                run.command(c, k < 10 ? 0 : 0.5);
            }
        }
        return run;
    }

    private static BelievedModel model() throws AuvsmlException {
        return new BelievedModel(
                ScenarioLoader.load(OverruledBehaviorsTest.class.getClassLoader())
                        .parse(MODEL.getBytes(UTF_8)),
                "box");
    }

    /** How fast it is in the end (m/s). */
    private static Vec3 velocity(MeasuredRunBuilder told) throws AuvsmlException {
        List<Entrant> alone = List.of(new Entrant(model().variant(), AT_REST));
        return Ensemble.simulate(model(), told.build(), 0, 20, alone)[0][20].velocity();
    }

    private static List<String> overruled(MeasuredRunBuilder told) throws AuvsmlException {
        return model().overruledBy(told.build()).stream().map(Behavior::name).toList();
    }

    private static void assertNear(Vec3 actual, Vec3 expected) {
        assertThat(actual.distance(expected)).as(actual.toString()).isCloseTo(0, within(1e-9));
    }

    @Test
    void withoutCommandsTheScenarioDrives() throws Exception {
        assertNear(velocity(told()), new Vec3(FULL, FULL, FULL));
        assertThat(overruled(told())).isEmpty();
    }

    @Test
    void commandsOfAThrusterTakeThePlaceOfItsScheduleAlone() throws Exception {
        assertNear(velocity(told("ahead")), new Vec3(FULL / 4, FULL, FULL));
        assertThat(overruled(told("ahead"))).containsExactly("ahead plan");
    }

    @Test
    void eachRunHasItsOwn() throws Exception {
        assertNear(velocity(told("ahead", "aside")), new Vec3(FULL / 4, FULL / 4, FULL));
        assertNear(velocity(told("aside")), new Vec3(FULL, FULL / 4, FULL));
    }

    /** In N, where those of thrusters are levels. */
    @Test
    void commandsOfAForceTakeThePlaceOfTheBehaviorThatAppliesIt() throws Exception {
        assertNear(velocity(told("lift.z")), new Vec3(FULL, FULL, FULL / 40));
        assertThat(overruled(told("lift.z"))).containsExactly("lift");
    }

    @Test
    void soDoesAForceThatActedForAWhile() throws Exception {
        NamedForce down = NamedForce.direct("lift", Frame.WORLD, new Vec3(0, 0, -10));
        ScheduledForce second = new ScheduledForce(1, 2, down);

        assertNear(velocity(told().force(second)), new Vec3(FULL, FULL, -FULL / 2));
    }
}
