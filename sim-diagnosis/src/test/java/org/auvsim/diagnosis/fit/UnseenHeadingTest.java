package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.LocalMotion;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.subject.MeasuredVehicle;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** A vehicle of which only positions are measured, at headings that the scenario does not know. */
class UnseenHeadingTest {
    @ParameterizedTest
    @ValueSource(doubles = {0, 1.2, 2.6, -1.9})
    void itsPathTellsHowItIsTurned(double yaw) throws Exception {
        BelievedModel model = MeasuredVehicle.model(0.05);

        Fit fit = assertTold(yaw, 0.1, model, path(MeasuredVehicle.run(model, level(yaw))));
        assertThat(fit.whole().outcome().cost()).isLessThan(1.2 * fit.outcome().count());
    }

    /** What a document states of a start says nothing of what it leaves out. */
    @Test
    void itDoesSoWhereItIsStatedWhereTheRunBegins() throws Exception {
        double yaw = 2.1;
        BelievedModel model = MeasuredVehicle.model(0.05);
        List<Double> deviations =
                new ArrayList<>(Collections.nCopies(12, Double.POSITIVE_INFINITY));
        for (int i : List.of(0, 1, 2, 6, 7, 8)) {
            deviations.set(i, 0.01);
        }
        MeasuredRun run =
                path(MeasuredVehicle.run(model, level(yaw)))
                        .startingAt(new KnownStart(level(0), deviations));

        assertTold(yaw, 0.2, model, LocalMotion.begun(run, model));
    }

    private static Fit assertTold(double yaw, double tilt, BelievedModel model, MeasuredRun run) {
        Noise noise = Noise.of(List.of(run));

        Fit fit =
                Following.of(
                        Stepping.exact(model),
                        Hypothesis.NONE,
                        Misses.of(List.of(run), noise),
                        noise);

        RigidMotion start = fit.whole().windows().getFirst().getFirst().start();
        Vec3 ahead = start.orientation().rotate(new Vec3(1, 0, 0));
        assertThat(Math.atan2(ahead.y(), ahead.x())).isCloseTo(yaw, within(0.1));
        assertThat(ahead.z()).isCloseTo(0, within(tilt));
        return fit;
    }

    private static RigidMotion level(double yaw) {
        return new RigidMotion(
                new Vec3(0.4, -0.3, 0.2),
                Quat.ofAxisAngle(new Vec3(0, 0, 1), yaw),
                Vec3.ZERO,
                Vec3.ZERO);
    }

    private static MeasuredRun path(MeasuredRun of) {
        MeasuredRunBuilder path = MeasuredRun.named("path").commands(List.of("port", "starboard"));
        for (int k = 0; k < of.size(); k++) {
            Vec3 p = of.vector(Channel.POSITION, k).orElseThrow();
            path.at(of.time(k)).position(p.x(), p.y(), p.z());
            for (int c = 0; c < 2; c++) {
                path.command(c, of.commands().get(c).level(k));
            }
        }
        return path.build();
    }
}
