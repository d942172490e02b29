package org.auvsim.diagnosis.report;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.plot.page.Block.Chart;
import org.auvsim.plot.page.Curve;
import org.auvsim.plot.page.Curve.Mark;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Charts of 90 s of rows at 10 Hz, in which the position is measured once a second. */
class RunChartsTest {
    private static final int ROWS = 900;
    private static final double SPEED = 2;
    private static final Vec3 AHEAD = new Vec3(SPEED, 0, 0);

    private final List<Chart> charts = charts(0);

    private static List<Chart> charts(double begin) {
        MeasuredRunBuilder run = MeasuredRun.named("fixes");
        List<RigidMotion> told = new ArrayList<>();
        for (int k = 0; k < ROWS; k++) {
            double x = k % 10 == 5 ? SPEED * k / 10 : Double.NaN;
            run.at(begin + k / 10.0).position(x, 0 * x, 0 * x);
            run.orientation(Quat.IDENTITY);
            Vec3 place = new Vec3(SPEED * k / 10, 0, 0);
            told.add(new RigidMotion(place, Quat.IDENTITY, AHEAD, Vec3.ZERO));
        }
        return charts(run.build(), told);
    }

    private static List<Chart> charts(MeasuredRun run, List<RigidMotion> told) {
        DiagnosedRun of = new DiagnosedRun(run, false, told, told, List.of(), Set.of());
        return new RunCharts(of, Map.of(), List.of("simulated"))
                .all().stream().filter(Chart.class::isInstance).map(Chart.class::cast).toList();
    }

    private Curve curve(String chart, String name) {
        return curve(charts, chart, name);
    }

    private static Curve curve(List<Chart> charts, String chart, String name) {
        return charts.stream()
                .filter(c -> c.title().equals(chart))
                .flatMap(c -> c.curves().stream())
                .filter(c -> c.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    private static long shown(Curve curve) {
        return curve.points().stream()
                .filter(point -> Double.isFinite(point.x()) && Double.isFinite(point.y()))
                .count();
    }

    @Test
    void everyFixIsOnThePath() {
        assertThat(shown(curve("The path from above", "measured"))).isEqualTo(90);
        assertThat(shown(curve("Height over time", "measured"))).isEqualTo(90);
    }

    /** Of a cart on a rail nobody sees anything from above. */
    @Test
    void oneWayIsDrawnOverTime() {
        MeasuredRunBuilder run = MeasuredRun.named("rail");
        List<RigidMotion> told = new ArrayList<>();
        for (int k = 0; k < ROWS; k++) {
            run.at(k / 10.0).measured(Channel.POSITION, SPEED * k / 10, Double.NaN, Double.NaN);
            Vec3 place = new Vec3(SPEED * k / 10, 0, 0);
            told.add(new RigidMotion(place, Quat.IDENTITY, AHEAD, Vec3.ZERO));
        }

        List<Chart> drawn = charts(run.build(), told);

        assertThat(shown(curve(drawn, "Way along x over time", "measured"))).isPositive();
        assertThat(drawn)
                .extracting(Chart::title)
                .doesNotContain("The path from above", "Way along y over time", "Height over time");
    }

    @Test
    void whatIsMissedOfFixesIsPoints() {
        Curve x = curve("Residual of the position, simulated", "x");
        assertThat(x.mark()).isEqualTo(Mark.POINTS);
        assertThat(shown(x)).isEqualTo(90);
        assertThat(curve("Residual of the orientation, simulated", "x").mark())
                .isEqualTo(Mark.LINE);
        assertThat(shown(curve("Residual of the position over the position, simulated", "x")))
                .isEqualTo(90);
    }

    @Test
    void fixesTellASpeed() {
        Curve measured = curve("Speed over time, by positions", "measured");
        assertThat(shown(measured)).isEqualTo(90);
        assertThat(measured.points())
                .filteredOn(point -> Double.isFinite(point.y()))
                .allMatch(point -> Math.abs(point.y() - SPEED) < 1e-9);
    }

    /** Charts have seven digits, of which those of UNIX time leave none for seconds. */
    @Test
    void unixTimesCountFromWhereTheRunBegins() {
        List<Chart> far = charts(1.718e9);

        for (String name : List.of("Height over time", "Residual of the orientation, simulated")) {
            assertThat(far)
                    .filteredOn(chart -> chart.title().equals(name))
                    .allMatch(chart -> chart.x().equals("time since the run began (s)"));
        }
        assertThat(curve(far, "Height over time", "simulated").points())
                .allMatch(point -> point.x() >= 0 && point.x() < 90.1);
        assertThat(curve(far, "Heading over time", "measured").points())
                .allMatch(point -> point.x() >= 0 && point.x() < 90.1);
    }
}
