package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.search.Way;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.subject.Cart;
import org.auvsim.diagnosis.subject.MeasuredVehicle;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;

/** What is proposed where no cause explains the runs is judged as causes are. */
@Tag("whole-search")
class ImitationTrialTest {
    /** A vehicle that tumbles too fast for its scenario's steps, its positions in feet. */
    private static MeasuredRun inFeet(Vec3 spin) throws Exception {
        MeasuredRun run = MeasuredVehicle.run(MeasuredVehicle.model(0.005), spin).stretch(0, 80);
        MeasuredRunBuilder feet =
                MeasuredRun.named(run.name()).commands(List.of("port", "starboard"));
        for (int k = 0; k < run.size(); k++) {
            Vec3 p = run.vector(Channel.POSITION, k).orElseThrow().times(1 / 0.3048);
            feet.at(run.time(k)).position(p.x(), p.y(), p.z());
            run.orientation(k).ifPresent(feet::orientation);
            for (int c = 0; c < 2; c++) {
                feet.command(c, run.commands().get(c).level(k));
            }
        }
        return feet.build();
    }

    @Test
    void stepsAreAsShortAsTheSearchFoundThatTheyHaveToBe() throws Exception {
        BelievedModel coarse = MeasuredVehicle.model(0.05);
        List<MeasuredRun> fit = List.of(inFeet(new Vec3(9, -2, 14)), inFeet(new Vec3(-8, 3, 12)));
        List<MeasuredRun> heldOut = List.of(inFeet(new Vec3(7, 4, -13)));
        List<Cause> causes = Library.named(List.of("mass_error"), Library.of(coarse, fit));
        List<Gain> gains = new ArrayList<>();

        Diagnosis of =
                new Examination(coarse, fit, heldOut, causes, 1, Way.THOROUGH, Progress.SILENT)
                        .diagnosis(
                                List.of(
                                        (_, trial) -> {
                                            trial.positionGain(same -> same).ifPresent(gains::add);
                                            return Optional.empty();
                                        }));

        assertThat(of.verdict()).isEqualTo(Verdict.UNEXPLAINED);
        Gain ofCauses =
                Optional.ofNullable(of.prediction().gains().get(Channel.POSITION)).orElseThrow();
        assertThat(gains).hasSize(1);
        assertThat(gains.getFirst().before()).isCloseTo(ofCauses.before(), within(1e-12));
        assertThat(gains.getFirst().after()).isCloseTo(ofCauses.before(), within(1e-12));
    }

    @Test
    void aTrialThatIsStoppedTellsNoGain() throws Exception {
        List<MeasuredRun> runs = List.of(new Cart(1, 4, 0.1).run());
        AtomicInteger asked = new AtomicInteger();
        Course course = new Course((stage, share) -> asked.incrementAndGet() < 3);

        Optional<Gain> gain =
                new ImitationTrial(Stepping.exact(Cart.believed()), runs, Noise.of(runs), course)
                        .positionGain(same -> same);

        assertThat(gain).isEmpty();
        assertThat(asked).hasValue(3);
    }
}
