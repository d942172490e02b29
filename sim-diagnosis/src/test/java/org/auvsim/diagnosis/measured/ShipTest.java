package org.auvsim.diagnosis.measured;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.measured.Nomoto.Zigzag;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.reading.RunFiles;
import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.Command;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;

/** The tanker KVLCC2 in two zigzags, one fitted in parts of 20 s and the other predicted whole. */
@Tag("measured-data")
class ShipTest {
    private static final double PART = 20;

    /** What water does to a ship in a calm tank. */
    private static final Set<String> OF_HULL_AND_RUDDER =
            Set.of(
                    "linear_drag",
                    "quadratic_drag",
                    "anisotropic_drag",
                    "rotational_drag",
                    "added_mass",
                    "hull_lift",
                    "fin_gain",
                    "fin_race");

    private final DataSet data = DataSet.named("ship-kvlcc2");

    @Test
    void theOtherZigzagIsPredictedTwiceAsWellAsByNomoto() throws Exception {
        BelievedModel model = data.model("ship.xml", "KVLCC2");
        RunFiles runs =
                DataSet.runs(
                        model,
                        data.example("columns.xml"),
                        List.of(data.file("hsva_Z_10_05.csv")),
                        List.of(data.file("hsva_Z_20_05.csv")));
        List<MeasuredRun> parts = runs.inParts(PART).fit();
        Diagnosis diagnosis =
                new Investigation(
                                model,
                                parts,
                                runs.heldOut(),
                                Library.of(model, parts).stream()
                                        .filter(cause -> OF_HULL_AND_RUDDER.contains(cause.id()))
                                        .toList(),
                                1,
                                Progress.SILENT)
                        .diagnose();
        DiagnosedRun predicted =
                diagnosis.runs().stream().filter(DiagnosedRun::isHeldOut).findFirst().orElseThrow();
        Zigzag measured = measured(runs.heldOut().getFirst());
        Zigzag told = told(runs.heldOut().getFirst(), predicted.after());
        Nomoto nomoto = Nomoto.fitted(measured(runs.fit().getFirst()));

        assertThat(rms(told.yawRate(), measured.yawRate()))
                .isLessThan(0.5 * rms(nomoto.yawRates(measured), measured.yawRate()));
        assertThat(rms(told.sway(), measured.sway()))
                .isLessThan(0.5 * rms(nomoto.sway(measured), measured.sway()));
        assertThat(diagnosis.verdict()).isEqualTo(Verdict.UNEXPLAINED);
        assertThat(diagnosis.conclusion().approximation()).isPresent();
    }

    private static Zigzag measured(MeasuredRun run) {
        double[] yawRate = new double[run.size()];
        double[] sway = new double[run.size()];
        for (int k = 0; k < run.size(); k++) {
            yawRate[k] = run.value(Channel.ANGULAR_VELOCITY, k, 2);
            Vec3 velocity =
                    new Vec3(
                            run.value(Channel.VELOCITY, k, 0),
                            run.value(Channel.VELOCITY, k, 1),
                            0);
            sway[k] = run.orientation(k).orElseThrow().rotateInverse(velocity).y();
        }
        return new Zigzag(spacing(run), rudder(run), yawRate, sway);
    }

    private static Zigzag told(MeasuredRun run, List<RigidMotion> motions) {
        double[] yawRate = motions.stream().mapToDouble(m -> m.angularVelocity().z()).toArray();
        double[] sway =
                motions.stream()
                        .mapToDouble(m -> m.orientation().rotateInverse(m.velocity()).y())
                        .toArray();
        return new Zigzag(spacing(run), rudder(run), yawRate, sway);
    }

    private static double spacing(MeasuredRun run) {
        return run.duration() / (run.size() - 1);
    }

    private static double[] rudder(MeasuredRun run) {
        Command rudder =
                run.commands().stream()
                        .filter(c -> c.name().equals("Rudder"))
                        .findFirst()
                        .orElseThrow();
        return IntStream.range(0, run.size()).mapToDouble(rudder::level).toArray();
    }

    private static double rms(double[] told, double[] measured) {
        double sum = 0;
        for (int k = 0; k < told.length; k++) {
            sum += (told[k] - measured[k]) * (told[k] - measured[k]);
        }
        return Math.sqrt(sum / told.length);
    }
}
