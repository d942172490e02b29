package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.LocalMotion;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.subject.Surveyor;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;

/** The model is right, but runs are said to begin somewhere else. */
@Tag("whole-search")
class SureStartsTest {
    private static final double STATED_TO = 0.002;

    private static MeasuredRun run(int seed, double quadratic, double east, BelievedModel model) {
        MeasuredRun run =
                new Surveyor(quadratic, Vec3.ZERO, 1, 0).run("run " + seed, new Random(seed));
        return stated(run, new Vec3(east, 0, -5), model);
    }

    /** Of its start the place eastwards is known, or so it is said. */
    private static MeasuredRun stated(MeasuredRun run, Vec3 place, BelievedModel model) {
        List<Double> deviations =
                new ArrayList<>(Collections.nCopies(RigidMotion.SIZE, Double.POSITIVE_INFINITY));
        deviations.set(0, STATED_TO);
        RigidMotion start = model.start();
        return run.startingAt(
                new KnownStart(
                        new RigidMotion(
                                place,
                                start.orientation(),
                                start.velocity(),
                                start.angularVelocity()),
                        deviations));
    }

    private static List<String> told(double quadratic, double... east) throws Exception {
        BelievedModel model = Surveyor.believed();
        List<MeasuredRun> fit =
                List.of(run(1, quadratic, east[0], model), run(2, quadratic, east[1], model));
        Diagnosis diagnosis =
                new Investigation(
                                model,
                                fit,
                                List.of(run(3, quadratic, east[2], model)),
                                Library.named(
                                        List.of("linear_drag", "sensor_delay"),
                                        Library.of(model, fit)),
                                1,
                                Progress.SILENT)
                        .diagnose();
        return diagnosis.notices().stream().filter(n -> n.contains("as stated")).toList();
    }

    @Test
    void areToldWhereNothingElseExplainsTheRuns() throws Exception {
        assertThat(told(0, 0.04, -0.03, 0.05))
                .singleElement()
                .asString()
                .startsWith(
                        "the model as it is explains all runs, if their starts need not be as"
                                + " stated: the position x of run 1 is off by 0.0")
                .contains(", the position x of run 2 is off by ", " m, and was stated to 0.0020 m");
    }

    /** What follows a gap, or a stretch, is taken to begin about as it was measured. */
    @Test
    void ofARunThatBeginsMidwayNoneIsStated() throws Exception {
        BelievedModel model = Surveyor.believed();
        MeasuredRun run = new Surveyor(0, Vec3.ZERO, 1, 0).run("run", new Random(1));
        MeasuredRun midway = run.stretch(50, run.size() - 1);

        assertThat(notice(model, stated(run, beside(run), model))).isPresent();
        assertThat(notice(model, stated(midway, beside(midway), model))).isEmpty();
    }

    private static Vec3 beside(MeasuredRun run) {
        return run.vector(Channel.POSITION, 0).orElseThrow().plus(new Vec3(0.04, 0, 0));
    }

    private static Optional<String> notice(BelievedModel model, MeasuredRun run) {
        List<MeasuredRun> runs = List.of(LocalMotion.begun(run, model));
        return new SureStarts(Stepping.exact(model), runs, Noise.of(runs), Course.UNHEARD).notice();
    }

    @Test
    void areNotBlamedForWhatAModelLacks() throws Exception {
        assertThat(told(12, 0, 0, 0)).isEmpty();
    }
}
