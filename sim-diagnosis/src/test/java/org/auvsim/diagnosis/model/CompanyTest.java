package org.auvsim.diagnosis.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.List;

/** A diagnosis moves one body among what is fixed. */
class CompanyTest {
    private static final String TETHER = "<tether to=\"7\" length=\"2\" stiffness=\"9\"/>";

    private static BelievedModel boat(String boat, String other) throws Exception {
        return Believed.model(
                """
                <scenario><time-step delta="0.01"/>
                  <world-object id="3" name="boat" mass="1"><sphere radius="0.1"/>%s</world-object>
                  <world-object id="7" name="other" %s<sphere radius="0.1"/>%s
                    <position x="3" y="0" z="0"/></world-object>
                </scenario>
                """
                        .formatted(
                                boat,
                                other.replaceFirst("(<.*)?$", ">"),
                                other.replaceFirst("^[^<]*", "")),
                "boat");
    }

    @Test
    void whoMovesTooIsLeftOut() throws Exception {
        assertThat(boat("", "mass=\"1\"").leftOut()).containsExactly("other");
        assertThat(boat("<ignores layer=\"4\"/>", "mass=\"1\" layer=\"4\"").leftOut()).isEmpty();
        assertThat(boat("", "fixed=\"1\"").leftOut()).isEmpty();
    }

    @Test
    void whoIsTiedToAnotherIsNotMovedAlone() throws Exception {
        assertThat(boat("", "mass=\"1\"").tie()).isEmpty();
        assertThat(boat(TETHER, "fixed=\"1\"").tie()).isEmpty();
        assertThat(boat(TETHER, "mass=\"1\"").tie())
                .hasValueSatisfying(
                        why ->
                                assertThat(why)
                                        .startsWith("'boat' is tied to 'other', which moves"));
        BelievedModel towed = boat("", "mass=\"1\"" + TETHER.replace('7', '3'));
        assertThat(towed.tie()).isPresent();
        Investigation investigation =
                new Investigation(
                        towed, List.of(run()), List.of(run()), List.of(), 1, Progress.SILENT);
        assertThatIllegalArgumentException()
                .isThrownBy(investigation::diagnose)
                .withMessageStartingWith("'boat' is tied to 'other'");
    }

    private static MeasuredRun run() {
        MeasuredRunBuilder run = MeasuredRun.named("pulled");
        for (int k = 0; k <= 60; k++) {
            run.at(0.01 * k).position(0, 0, 0);
        }
        return run.build();
    }

    /** By a line of 9 N/m that is 1 m too long, to a post that it would not run into. */
    @Test
    void whatItIsTiedToIsThereThoughItIgnoresIt() throws Exception {
        BelievedModel moored = boat(TETHER + "<ignores layer=\"4\"/>", "fixed=\"1\" layer=\"4\"");
        RigidMotion still = new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);

        RigidMotion[] motion =
                Ensemble.simulate(
                        moored, run(), 0, 60, List.of(new Entrant(moored.variant(), still)))[0];

        assertThat(motion[50].position().x()).isCloseTo(1 - Math.cos(3 * 0.5), within(1e-3));
    }
}
