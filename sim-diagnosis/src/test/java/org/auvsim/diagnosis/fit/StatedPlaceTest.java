package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
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
    private static final double HEADING = -2.2;

    /** Roll and pitch would bend its path, and do for a rudder that is worn. */
    @Test
    void whatIsNeitherStatedNorShownStaysAsInTheModel() throws Exception {
        Fit fit = followed(MeasuredTorpedo.model(MeasuredTorpedo.RUDDER));

        Window first = fit.windows().getFirst().getFirst();
        Vec3 up = first.start().orientation().rotate(new Vec3(0, 0, 1));
        assertThat(up.z()).isCloseTo(1, within(1e-9));
    }

    private static Fit followed(BelievedModel model) throws Exception {
        BelievedModel worn = MeasuredTorpedo.model(MeasuredTorpedo.WORN);
        List<MeasuredRun> runs = List.of(stated(MeasuredTorpedo.run(worn, 2, HEADING, Vec3.ZERO)));
        Noise noise = Noise.of(runs);
        return Following.of(
                Stepping.longer(model).getFirst(), Hypothesis.NONE, Misses.of(runs, noise), noise);
    }

    private static MeasuredRun stated(MeasuredRun run) {
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
                                Quat.ofAxisAngle(new Vec3(0, 0, 1), HEADING),
                                Vec3.ZERO,
                                Vec3.ZERO),
                        deviations));
    }
}
