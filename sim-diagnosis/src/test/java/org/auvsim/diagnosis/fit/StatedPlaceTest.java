package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.diagnosis.subject.MeasuredTorpedo;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * A torpedo of which it is stated where it begins and how fast, but not how it is turned; its place
 * and its heading are measured.
 */
class StatedPlaceTest {
    private static final double DEVIATION = 0.02;

    /** Roll and pitch would bend its path, and do for a rudder that is worn. */
    @Test
    void whatIsNeitherStatedNorShownStaysAsInTheModel() throws Exception {
        Fit fit = followed(MeasuredTorpedo.model(MeasuredTorpedo.RUDDER));

        for (List<Window> windows : fit.windows()) {
            Vec3 up = windows.getFirst().start().orientation().rotate(new Vec3(0, 0, 1));
            assertThat(up.z()).isCloseTo(1, within(1e-9));
        }
    }

    /** What is stated of starts bounds how well the zero of a sensor is known. */
    @Test
    void theZeroOfASensorIsNotKnownBetterThanTheStarts() throws Exception {
        BelievedModel model = MeasuredTorpedo.model(MeasuredTorpedo.WORN);
        Fit followed = followed(model);
        List<MeasuredRun> runs = followed.data().stream().map(Misses::run).toList();
        Cause offset =
                Library.of(model, runs).stream()
                        .filter(cause -> cause.id().equals("sensor_offset"))
                        .findFirst()
                        .orElseThrow();
        Hypothesis hypothesis = Hypothesis.NONE.and(offset, new double[] {0, 0, 0});

        Judged fitted = Descent.of(followed.with(hypothesis, followed.windows()).whole()).steps(40);

        assertThat(fitted.cost())
                .isCloseTo(Descent.of(fitted).finely().steps(40).cost(), within(0.5));
        List<Double> deviations = new Uncertainty(fitted).deviations().getFirst();
        assertThat(deviations)
                .allSatisfy(d -> assertThat(d).isGreaterThan(DEVIATION / Math.sqrt(runs.size())));
    }

    private static Fit followed(BelievedModel model) throws Exception {
        BelievedModel worn = MeasuredTorpedo.model(MeasuredTorpedo.WORN);
        List<MeasuredRun> runs =
                List.of(
                        stated(MeasuredTorpedo.run(worn, 1, 0.3, Vec3.ZERO), 0.3),
                        stated(MeasuredTorpedo.run(worn, 2, -2.2, Vec3.ZERO), -2.2),
                        stated(MeasuredTorpedo.run(worn, 3, 1.9, Vec3.ZERO), 1.9));
        Noise noise = Noise.of(runs);
        return Following.of(
                Stepping.longer(model).getFirst(), Hypothesis.NONE, Misses.of(runs, noise), noise);
    }

    private static MeasuredRun stated(MeasuredRun run, double heading) {
        List<Double> deviations =
                new ArrayList<>(Collections.nCopies(RigidMotion.SIZE, Double.POSITIVE_INFINITY));
        for (int axis = 0; axis < 3; axis++) {
            deviations.set(axis, DEVIATION);
            deviations.set(6 + axis, DEVIATION);
        }
        return run.startingAt(
                new KnownStart(
                        new RigidMotion(
                                new Vec3(0, 0, -15),
                                Quat.ofAxisAngle(new Vec3(0, 0, 1), heading),
                                Vec3.ZERO,
                                Vec3.ZERO),
                        deviations));
    }
}
