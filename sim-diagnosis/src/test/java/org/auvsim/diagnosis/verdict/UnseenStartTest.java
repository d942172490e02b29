package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.diagnosis.subject.MeasuredVehicle;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/**
 * What a run does not show of its start stays as the model has it. A sideways velocity of its own
 * would make the drag of a falling ball what the fit needs.
 */
class UnseenStartTest {
    private static final double GRAVITY = 9.80665;
    private static final double DRAG = 0.12;
    private static final double MASS = 0.3;
    private static final double NOISE = 0.02;

    @Test
    void aBallOfWhichOnlyTheHeightIsMeasuredFallsStraight() throws Exception {
        Diagnosis diagnosis = diagnosis("");

        assertThat(diagnosis.selected()).hasSize(1);
        assertThat(diagnosis.selected().getFirst().cause()).isEqualTo("linear_drag");
        assertThat(diagnosis.selected().getFirst().quantities().getFirst().value())
                .isCloseTo(DRAG, within(0.002));
        assertThat(diagnosis.runs())
                .flatExtracting(run -> run.after())
                .allSatisfy(
                        motion -> {
                            assertThat(motion.position().x()).isCloseTo(0, within(1e-4));
                            assertThat(motion.velocity().y()).isCloseTo(0, within(1e-4));
                        });
    }

    /** By its height, a ball that is thrown by the scenario may just as well have been dropped. */
    @Test
    void thatNothingTellsHowFastItBeginsIsSaid() throws Exception {
        assertThat(diagnosis("<velocity x='2' y='0' z='0'/>").notices())
                .contains(
                        "nothing that is measured tells how fast one, two, three begin: at the"
                            + " scenario's 2.0 m/s; what began otherwise may look like a current:"
                            + " state its start");
        assertThat(diagnosis("").notices())
                .contains(
                        "nothing that is measured tells how fast one, two, three begin: at rest, as"
                            + " in the scenario; what began otherwise may look like a cause: state"
                            + " its start");
    }

    /** Where the drag is known nothing is wrong, and where the ball begins does not matter. */
    @Test
    void thatItBeginsAtRestIsNotSaidWhereNothingIsWrong() throws Exception {
        Diagnosis diagnosis = diagnosis("<damping><linear x='0.12' y='0.12' z='0.12'/></damping>");

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.NONE);
        assertThat(diagnosis.notices()).noneMatch(notice -> notice.contains("how fast"));
    }

    private static Diagnosis diagnosis(String more) throws Exception {
        BelievedModel model =
                Believed.model(
                        """
                        <scenario><time-step delta="0.02"/>
                          <world-object name="Ball" mass="0.3">
                            <sphere radius="0.1"/>%s<gravity/>
                          </world-object>
                        </scenario>
                        """
                                .formatted(more),
                        "Ball");
        List<MeasuredRun> fit = List.of(drop("one", 1, 1), drop("two", -2, 2));
        return new Investigation(
                        model,
                        fit,
                        List.of(drop("three", 0, 3)),
                        Library.of(model, fit).stream()
                                .filter(cause -> cause.id().endsWith("_drag"))
                                .toList(),
                        1,
                        Progress.SILENT)
                .diagnose();
    }

    /** Roll and pitch would tilt its thrust, and do for a drag that the model lacks. */
    @Test
    void aVehicleOfWhichOnlyTheHeadingIsMeasuredStaysLevel() throws Exception {
        BelievedModel level = MeasuredVehicle.model(0.05);
        MeasuredRun run = MeasuredVehicle.run(level);
        MeasuredRunBuilder heading = MeasuredRun.named("heading");
        for (int k = 0; k < run.size(); k++) {
            Vec3 place = run.vector(Channel.POSITION, k).orElseThrow();
            heading.at(run.time(k))
                    .position(place.x(), place.y(), place.z())
                    .orientation(run.orientation(k).orElseThrow(), false, false, true);
        }
        MeasuredRun measured = heading.build();

        assertThat(new Misses(measured, Noise.of(List.of(measured))).shown(0))
                .containsExactly(
                        true, true, true, false, false, true, true, true, true, false, false, true);
    }

    /** Its height by the solution of m dv/dt = -m g - c v, with noise. */
    private static MeasuredRun drop(String name, double speed, long seed) {
        Random random = new Random(seed);
        MeasuredRunBuilder run = MeasuredRun.named(name);
        double rate = DRAG / MASS;
        double last = -GRAVITY / rate;
        for (int k = 0; k < 60; k++) {
            double t = k / 15.0;
            double z = last * t + (speed - last) * (1 - Math.exp(-rate * t)) / rate;
            run.at(t).position(Double.NaN, Double.NaN, z + NOISE * random.nextGaussian());
        }
        return run.build();
    }
}
