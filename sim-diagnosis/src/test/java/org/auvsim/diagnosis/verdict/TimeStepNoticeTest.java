package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.diagnosis.subject.MeasuredVehicle;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;

/** A vehicle that tumbles too fast for its scenario's time step. */
@Tag("whole-search")
class TimeStepNoticeTest {
    private static Diagnosis diagnosis(double positionUnit) throws Exception {
        BelievedModel coarse = MeasuredVehicle.model(0.05);
        BelievedModel fine = MeasuredVehicle.model(0.005);
        List<MeasuredRun> fit =
                List.of(
                        in(positionUnit, MeasuredVehicle.run(fine, new Vec3(9, -2, 14))),
                        in(positionUnit, MeasuredVehicle.run(fine, new Vec3(-8, 3, 12))));
        List<MeasuredRun> heldOut =
                List.of(in(positionUnit, MeasuredVehicle.run(fine, new Vec3(7, 4, -13))));
        return Believed.suspectedOf("mass_error", coarse, fit, heldOut);
    }

    private static MeasuredRun in(double unit, MeasuredRun run) {
        MeasuredRunBuilder other =
                MeasuredRun.named(run.name()).commands(List.of("port", "starboard"));
        for (int k = 0; k < run.size(); k++) {
            Vec3 p = run.vector(Channel.POSITION, k).orElseThrow().times(1 / unit);
            other.at(run.time(k)).position(p.x(), p.y(), p.z());
            run.orientation(k).ifPresent(other::orientation);
            for (int c = 0; c < 2; c++) {
                other.command(c, run.commands().get(c).level(k));
            }
        }
        return other.build();
    }

    @Test
    void aStepThatIsTooLongIsTold() throws Exception {
        Diagnosis sound = diagnosis(1);

        assertThat(sound.verdict()).isEqualTo(Verdict.NONE);
        assertThat(sound.notices()).anyMatch(notice -> notice.contains("time step of 0.05 s"));
    }

    /** The steps that data needs which no model fits are no fault of the scenario. */
    @Test
    void ofPositionsInFeetItIsNotTold() throws Exception {
        Diagnosis wrong = diagnosis(0.3048);

        assertThat(wrong.verdict()).isEqualTo(Verdict.UNEXPLAINED);
        assertThat(wrong.notices()).noneMatch(notice -> notice.contains("time step"));
    }
}
