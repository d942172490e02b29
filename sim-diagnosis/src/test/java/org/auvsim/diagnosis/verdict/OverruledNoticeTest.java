package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.core.behavior.PropulsorSchedule;
import org.auvsim.core.behavior.PropulsorSchedule.TimedLevel;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.diagnosis.subject.MeasuredVehicle;
import org.junit.jupiter.api.Test;

import java.util.List;

/** A sound vehicle that a log drives, while the scenario has another plan for it. */
class OverruledNoticeTest {
    private static BelievedModel planned(BelievedModel model, String... thrusters) {
        WorldObjectDefinition.Builder body = model.variant().body().toBuilder();
        for (String thruster : thrusters) {
            body.component(
                    new PropulsorSchedule(
                            thruster + " plan", thruster, List.of(new TimedLevel(0, -1))));
        }
        Scenario scenario = model.scenario();
        return new BelievedModel(
                scenario.with(scenario.field(), List.of(body.build())), model.body());
    }

    private static Diagnosis diagnosis(String... thrusters) throws Exception {
        BelievedModel model = MeasuredVehicle.model(0.05);
        List<MeasuredRun> fit = List.of(MeasuredVehicle.run(model));
        List<MeasuredRun> heldOut = List.of(MeasuredVehicle.run(model, new Vec3(-0.1, 0.2, 0.1)));
        return Believed.suspectedOf("mass_error", planned(model, thrusters), fit, heldOut);
    }

    @Test
    void theLogDrivesAndANoticeSaysSo() throws Exception {
        Diagnosis of = diagnosis("port", "starboard");

        assertThat(of.verdict()).isEqualTo(Verdict.NONE);
        assertThat(of.notices())
                .contains(
                        "the scenario's 'port plan', 'starboard plan' do not act: the runs have the"
                                + " commands that these would give");
        assertThat(of.extended().worldObject().getFirst().component())
                .as("in the scenario that is written")
                .hasSize(4);
    }
}
