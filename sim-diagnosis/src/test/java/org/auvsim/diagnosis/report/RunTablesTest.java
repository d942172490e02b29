package org.auvsim.diagnosis.report;

import static org.assertj.core.api.Assertions.assertThat;

import org.assertj.core.data.Offset;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.Reading;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.io.StringWriter;
import java.util.List;
import java.util.Set;

class RunTablesTest {
    private static final double QUARTER = Math.PI / 2;

    private static RigidMotion motion(double x, double yaw, double speed) {
        return new RigidMotion(
                new Vec3(x, 0, 0),
                Quat.ofAxisAngle(new Vec3(0, 0, 1), yaw),
                new Vec3(0, speed, 0),
                Vec3.ZERO);
    }

    /** Depth, heading and the body's forward speed are measured; the second model breaks off. */
    private static DiagnosedRun run() {
        MeasuredRun run =
                MeasuredRun.named("run")
                        .frame(Channel.VELOCITY, Frame.BODY)
                        .at(0)
                        .position(Double.NaN, Double.NaN, 0.5)
                        .orientation(
                                Quat.ofAxisAngle(new Vec3(0, 0, 1), QUARTER + 0.25),
                                false,
                                false,
                                true)
                        .measured(Channel.VELOCITY, 3, Double.NaN, Double.NaN)
                        .at(1)
                        .position(Double.NaN, Double.NaN, 0.75)
                        .build();
        return new DiagnosedRun(
                run,
                true,
                List.of(motion(1, QUARTER, 2), motion(2, QUARTER, 2)),
                List.of(motion(4, QUARTER + 0.25, 3)),
                List.of(),
                Set.of(new Reading(Channel.POSITION, 1, 2), new Reading(Channel.VELOCITY, 1, 0)));
    }

    @Test
    void residualsAreMeasuredLessSimulated() throws IOException {
        StringWriter out = new StringWriter();
        RunTables.residuals(run(), out);
        String[] lines = out.toString().split("\r?\n", -1);
        assertThat(lines[0])
                .isEqualTo(
                        "t,position.x.before,position.x.after,position.y.before,position.y.after,"
                                + "position.z.before,position.z.after,"
                                + "orientation.x.before,orientation.x.after,"
                                + "orientation.y.before,orientation.y.after,"
                                + "orientation.z.before,orientation.z.after,"
                                + "velocity.x.before,velocity.x.after,velocity.y.before,"
                                + "velocity.y.after,velocity.z.before,velocity.z.after,left_out");
        String[] first = lines[1].split(",", -1);
        assertThat(List.of(first).subList(0, 7))
                .containsExactly("0.0", "", "", "", "", "0.5", "0.5");
        assertThat(Double.parseDouble(first[11])).isCloseTo(0.25, within(1e-12));
        assertThat(Double.parseDouble(first[12])).isCloseTo(0, within(1e-12));
        assertThat(Double.parseDouble(first[13])).isCloseTo(1, within(1e-12));
        assertThat(Double.parseDouble(first[14])).isCloseTo(3 - 3 * Math.cos(0.25), within(1e-12));
        assertThat(lines[2]).isEqualTo("1.0,,,,,0.75,,,,,,,,,,,,,,position.z velocity.x");
        assertThat(lines[1]).endsWith(",");
    }

    private static Offset<Double> within(double offset) {
        return Offset.offset(offset);
    }

    @Test
    void predictionsEndWhereTheModelBreaksOff() throws IOException {
        StringWriter out = new StringWriter();
        RunTables.prediction(run(), out);
        assertThat(out.toString().lines()).hasSize(2).first().isEqualTo("t,x,y,z,qw,qx,qy,qz");
        assertThat(out.toString().lines().toList().get(1)).startsWith("0.0,4.0,0.0,0.0,0.");
    }

    @Test
    void tablesHaveNamesThatDifferAndThatAnySystemTakes() {
        MeasuredRun any = run().run();
        List<DiagnosedRun> runs =
                List.of("a/b c.csv", "Run", "run.CSV", "../x", "").stream()
                        .map(
                                name ->
                                        new DiagnosedRun(
                                                any.part(name, 0, 1),
                                                false,
                                                List.of(),
                                                List.of(),
                                                List.of(),
                                                Set.of()))
                        .toList();
        assertThat(NamedRun.of(runs))
                .extracting(NamedRun::name)
                .containsExactly("a_b_c.csv", "Run.csv", "run-2.csv", "__x.csv", "run-3.csv");
    }
}
