package org.auvsim.experiments.cfs;

import org.auvsim.experiments.cfs.CfsExperiment.Runs;
import org.auvsim.experiments.cfs.Telling.Hiccups;
import org.auvsim.experiments.cfs.Telling.OwnWay;
import org.auvsim.plot.page.Block.Chart;
import org.auvsim.plot.page.Block.Table;
import org.auvsim.plot.page.Block.Text;
import org.auvsim.plot.page.Curve;
import org.auvsim.plot.page.Curve.Mark;
import org.auvsim.plot.page.Curve.Point;
import org.auvsim.plot.page.Report;
import org.auvsim.plot.page.Report.Section;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/** What the experiment found, beside what the thesis reported. */
record CfsReport(
        double rate, List<Point> alone, Runs asynchronous, Runs lockstep, List<Growth> growth) {
    private static final String TIME = "world time (s)";

    /** Half the time (s) that is seen closer. */
    private static final double CLOSE = 2;

    Report report() {
        return new Report(
                "Corrective feedback (thesis, section 8.1)",
                String.format(
                        Locale.ROOT,
                        "When the simulator does not wait, object C is off its client's own"
                            + " position by %.3g m (RMS), which is %.3g s at its speed: the lag"
                            + " that the thesis saw. In lock-step, which the thesis proposed, it is"
                            + " off by %.3g m.",
                        asynchronous.c().rmsError(),
                        asynchronous.c().rmsError() / OwnWay.SPEED,
                        lockstep.c().rmsError()),
                List.of(
                        threeObjects(
                                "Asynchronous, as in the thesis",
                                String.format(
                                        Locale.ROOT,
                                        "The simulator goes on at %.0f times real time and uses"
                                                + " feedback between two steps, whenever it has"
                                                + " arrived.",
                                        rate),
                                asynchronous,
                                "As in the thesis: A is smooth, B a jerky copy of it, C goes where"
                                        + " its client says, and late."),
                        threeObjects(
                                "In lock-step, which the thesis left to future work",
                                "The simulator shows each step before it makes it, and waits for"
                                    + " the answer: feedback is used in the step that it is for.",
                                lockstep,
                                "B is as jerky, for its client means it; C is where its client"
                                        + " is."),
                        errors(),
                        growthSection()));
    }

    private Section threeObjects(String heading, String what, Runs runs, String reading) {
        return Section.of(
                heading,
                new Text(what),
                new Chart(
                        "Figure 8.1: the objects' positions along y",
                        TIME,
                        "y (m)",
                        List.of(
                                Curve.line("A", alone),
                                Curve.line("B", runs.b().simulated()),
                                Curve.line("C", runs.c().simulated()),
                                new Curve("C's client's own S", Mark.DASHED, runs.c().told())),
                        reading));
    }

    /** C and its client around the longest stop. */
    private Chart closer() {
        double middle = asynchronous.c().timeOfLargestError();
        return new Chart(
                "Object C and its client, closer",
                TIME,
                "y (m)",
                List.of(
                        Curve.line("C", around(middle, asynchronous.c().simulated())),
                        new Curve(
                                "C's client's own S",
                                Mark.DASHED,
                                around(middle, asynchronous.c().told()))),
                "The object follows its client late, stops for a while, and catches up with a"
                        + " jump.");
    }

    private static List<Point> around(double middle, List<Point> points) {
        return points.stream().filter(p -> Math.abs(p.x() - middle) < CLOSE).toList();
    }

    private Section errors() {
        return Section.of(
                "The errors of both",
                new Text(
                        String.format(
                                Locale.ROOT,
                                "Object less robot: where the object was less where the robot said"
                                    + " to be at that time. B's client says now and then that it is"
                                    + " up to %.1f m elsewhere; C's moves at %.2f m/s.",
                                Hiccups.LARGEST,
                                OwnWay.SPEED)),
                closer(),
                new Chart(
                        "Object C less its client's own S",
                        TIME,
                        "error (m)",
                        List.of(
                                Curve.line("asynchronous", asynchronous.c().errors()),
                                Curve.line("lock-step", lockstep.c().errors())),
                        "Asynchronous feedback comes a step or more late, a different number each"
                                + " time; in lock-step there is nothing to see."),
                new Table(
                        List.of(
                                "object",
                                "positions told",
                                "RMS error (m)",
                                "largest (m)",
                                "steps at a standstill"),
                        Stream.of(asynchronous.b(), lockstep.b(), asynchronous.c(), lockstep.c())
                                .map(CfsReport::row)
                                .toList(),
                        "The short stops of C that the thesis mentions are steps into which no"
                                + " feedback came; in lock-step there are none."));
    }

    private static List<String> row(FeedbackRun run) {
        return List.of(
                run.name(),
                Integer.toString(run.told().size()),
                String.format(Locale.ROOT, "%.3g", run.rmsError()),
                String.format(Locale.ROOT, "%.3g", run.largestError()),
                String.format(Locale.ROOT, "%.1f %%", 100 * run.standstill()));
    }

    private Section growthSection() {
        return Section.of(
                "Why A goes farther each time",
                new Text(
                        "A's behavior looks once a step where it is. The push begins and ends up to"
                            + " a step late, so that it takes a little less energy on the way out"
                            + " than it gives on the way back."),
                new Chart(
                        "A's turning points",
                        TIME,
                        "distance from the middle (m)",
                        growth.stream()
                                .map(
                                        g ->
                                                Curve.line(
                                                        String.format(
                                                                Locale.ROOT,
                                                                "step %s s",
                                                                g.timeStep()),
                                                        g.turns()))
                                .toList(),
                        "The thesis saw A go farther in both directions over time; it is an effect"
                                + " of the time step, and goes with it."),
                new Table(
                        List.of("time step (s)", "first turn (m)", "last turn (m)", "at (s)"),
                        growth.stream().map(CfsReport::row).toList(),
                        "With a push that is switched where the limit is, every turn would be 2.5 m"
                                + " from the middle."));
    }

    private static List<String> row(Growth growth) {
        return List.of(
                Double.toString(growth.timeStep()),
                String.format(Locale.ROOT, "%.4f", growth.first()),
                String.format(Locale.ROOT, "%.4f", growth.last()),
                String.format(Locale.ROOT, "%.0f", growth.turns().getLast().x()));
    }
}
