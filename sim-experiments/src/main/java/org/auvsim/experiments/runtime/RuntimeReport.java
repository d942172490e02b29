package org.auvsim.experiments.runtime;

import org.auvsim.experiments.thesis.PolynomialFit;
import org.auvsim.experiments.thesis.StageCost;
import org.auvsim.experiments.thesis.Trend;
import org.auvsim.plot.page.Block;
import org.auvsim.plot.page.Block.Chart;
import org.auvsim.plot.page.Block.Table;
import org.auvsim.plot.page.Block.Text;
import org.auvsim.plot.page.Curve;
import org.auvsim.plot.page.Curve.Mark;
import org.auvsim.plot.page.Curve.Point;
import org.auvsim.plot.page.Report;
import org.auvsim.plot.page.Report.Section;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;

/** What the runtime experiment found, beside what the thesis reported. */
record RuntimeReport(double seconds, List<Measured> own, List<Measured> common, CubeSize watched) {
    private static final String BODIES = "bodies";

    Report report() {
        Measured last = own.getLast();
        return new Report(
                "Runtime of the thesis' algorithms (thesis, section 8.2)",
                String.format(
                        Locale.ROOT,
                        "%.0f s of world time with %d spheres take %.3g s with SnapshotStepper,"
                            + " which is built of the thesis' three stages, and %.3g s with"
                            + " EventStepper. In the thesis, 120 s with 100 objects took about 120"
                            + " s on a machine that it does not state.",
                        seconds,
                        last.bodies(),
                        last.snapshots().wallSeconds(),
                        last.eventSeconds()),
                List.of(
                        operations(),
                        realTime(own, "Real time against world time, targets of their own"),
                        realTime(common, "The same with one target for all"),
                        oneTarget()));
    }

    private Section operations() {
        List<Block> blocks = new ArrayList<>();
        blocks.add(
                new Text(
                        "Equal spheres stand in a cube with gaps of five diameters and are driven"
                                + " toward targets close to each other. Primitive operations are"
                                + " counted over "
                                + StageCost.ADVANCEMENTS
                                + " advancements as the thesis counted them: 1 for an assignment or"
                                + " an arithmetic operation, n for a call on a list of n."));
        blocks.add(
                stage(
                        Trend.RESTRICTER,
                        "Each sphere is asked once how far it goes, and once more"
                                + " for each halving: linear, as in the thesis."));
        blocks.add(
                stage(
                        Trend.OCTREE,
                        "Nearly linear, as in the thesis: what is left are the numbers of"
                                + " spheres at which the tree gets deeper."));
        blocks.add(
                stage(
                        Trend.FINDER,
                        "The thesis found a parabola. A larger cube meets later and each time"
                            + " spends more of its 100 advancements on the way there, so that ours"
                            + " need not be one: see R² below."));
        blocks.add(fits(own));
        return new Section("Operations of the three stages", blocks);
    }

    private Chart stage(Trend trend, String reading) {
        List<StageCost> costs = snapshots(own);
        PolynomialFit fit = trend.fit(costs);
        return new Chart(
                trend.title(),
                BODIES,
                "operations over " + StageCost.ADVANCEMENTS + " advancements",
                List.of(
                        points("counted", own, m -> value(trend, m)),
                        fitted(String.format(Locale.ROOT, "fit, R² = %.6f", fit.rSquared()), fit)),
                reading);
    }

    private static double value(Trend trend, Measured measured) {
        return trend.values(List.of(measured.snapshots()))[0];
    }

    private Section realTime(List<Measured> measured, String heading) {
        List<StageCost> costs = snapshots(measured);
        PolynomialFit quadratic = Trend.WALL_TIME.fit(costs);
        PolynomialFit cubic = Trend.WALL_TIME_CUBIC.fit(costs);
        Chart chart =
                new Chart(
                        "Figure 8.7: " + heading.toLowerCase(Locale.ROOT),
                        BODIES,
                        String.format(
                                Locale.ROOT, "real time (s) of %.0f s of world time", seconds),
                        List.of(
                                points(
                                        "SnapshotStepper",
                                        measured,
                                        m -> m.snapshots().wallSeconds()),
                                points("EventStepper", measured, Measured::eventSeconds),
                                fitted(
                                        String.format(
                                                Locale.ROOT,
                                                "quadratic fit, R² = %.4f",
                                                quadratic.rSquared()),
                                        quadratic),
                                fitted(
                                        String.format(
                                                Locale.ROOT,
                                                "cubic fit, R² = %.4f",
                                                cubic.rSquared()),
                                        cubic)),
                        String.format(
                                Locale.ROOT,
                                "The cubic fit's leading coefficient is %.3g here and 9.91985e-5 in"
                                    + " the thesis. Real time would be %.0f s. EventStepper needs"
                                    + " less since it does not shorten the steps of all bodies when"
                                    + " two of them meet. Best of %d runs.",
                                cubic.leading(),
                                seconds,
                                Measured.RUNS));
        return Section.of(heading, chart, times(measured));
    }

    private Table times(List<Measured> measured) {
        return new Table(
                List.of(
                        BODIES,
                        "SnapshotStepper (s)",
                        "× real time",
                        "EventStepper (s)",
                        "× real time"),
                measured.stream().map(this::times).toList(),
                "World time by real time says how much faster than real time a run is.");
    }

    private List<String> times(Measured measured) {
        double snapshots = measured.snapshots().wallSeconds();
        double events = measured.eventSeconds();
        return List.of(
                Integer.toString(measured.bodies()),
                String.format(Locale.ROOT, "%.4f", snapshots),
                String.format(Locale.ROOT, "%.0f", seconds / snapshots),
                String.format(Locale.ROOT, "%.4f", events),
                String.format(Locale.ROOT, "%.0f", seconds / events));
    }

    private Table fits(List<Measured> measured) {
        List<StageCost> costs = snapshots(measured);
        List<List<String>> rows = new ArrayList<>();
        for (Trend trend : List.of(Trend.RESTRICTER, Trend.OCTREE, Trend.FINDER)) {
            PolynomialFit fit = trend.fit(costs);
            OptionalDouble thesis = trend.thesisRSquared();
            rows.add(
                    List.of(
                            trend.title(),
                            String.format(Locale.ROOT, "%.6f", fit.rSquared()),
                            thesis.isPresent()
                                    ? String.format(Locale.ROOT, "%.6f", thesis.getAsDouble())
                                    : "not given",
                            String.format(Locale.ROOT, "%.4g", fit.leading())));
        }
        return new Table(
                List.of("figure", "R² here", "R² in the thesis", "leading coefficient here"),
                rows,
                "Counts are the same on every machine and in every run; the finder's depend on how"
                        + " often spheres meet, which no formula tells.");
    }

    private Section oneTarget() {
        return Section.of(
                "Collapse and expansion",
                new Chart(
                        watched.bodies() + " spheres about their middle (EventStepper)",
                        "world time (s)",
                        "mean distance from the middle (m)",
                        List.of(
                                Curve.line("one target for all", watched.oneTarget()),
                                Curve.line("targets of their own", watched.ownTargets())),
                        "Both cubes fall together and bounce back to nearly their old size. The"
                            + " thesis saw one with one target do so over and over; here positions"
                            + " that differ by a micrometre from a perfect lattice break its"
                            + " symmetry in the first collisions, and a swarm without a beat is"
                            + " left."));
    }

    private static List<StageCost> snapshots(List<Measured> measured) {
        return measured.stream().map(Measured::snapshots).toList();
    }

    private static Curve points(
            String name, List<Measured> measured, ToDoubleFunction<Measured> value) {
        return new Curve(
                name,
                Mark.POINTS,
                measured.stream().map(m -> new Point(m.bodies(), value.applyAsDouble(m))).toList());
    }

    private Curve fitted(String name, PolynomialFit fit) {
        List<Point> points = new ArrayList<>();
        for (int n = own.getFirst().bodies(); n <= own.getLast().bodies(); n++) {
            points.add(new Point(n, fit.at(n)));
        }
        return new Curve(name, Mark.DASHED, points);
    }
}
