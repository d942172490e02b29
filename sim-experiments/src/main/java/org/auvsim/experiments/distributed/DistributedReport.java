package org.auvsim.experiments.distributed;

import org.auvsim.plot.page.Block.Chart;
import org.auvsim.plot.page.Block.Table;
import org.auvsim.plot.page.Block.Text;
import org.auvsim.plot.page.Curve;
import org.auvsim.plot.page.Curve.Mark;
import org.auvsim.plot.page.Report;
import org.auvsim.plot.page.Report.Section;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** What the experiment found, beside what the thesis reported. */
record DistributedReport(double rate, Trace local, List<Trace> asynchronous, List<Trace> lockstep) {
    Report report() {
        return new Report(
                "Distributed and non-distributed simulation (thesis, section 8.3)",
                summary(),
                List.of(
                        section(
                                "Asynchronous, as in the thesis",
                                String.format(
                                        Locale.ROOT,
                                        "Each client hears of its sphere's movements and sends the"
                                            + " force toward the target, at %.0f times real time;"
                                            + " the simulator does not wait. In the thesis, all"
                                            + " four curves of Figure 8.8 differ.",
                                        rate),
                                asynchronous,
                                "Figure 8.8: distance of the first sphere from the target",
                                "A force acts some steps late, a different number each time. What"
                                    + " comes late gives energy each time round, so that spheres"
                                    + " fly farther; after the first collisions the runs have"
                                    + " nothing in common but their beginning."),
                        section(
                                "In lock-step, which the thesis left to future work",
                                "The same clients compute the same law from where each step is"
                                    + " projected to end, and the simulator waits for all of them."
                                    + " It runs as fast as they answer.",
                                lockstep,
                                "Distance of the first sphere from the target, in lock-step",
                                agrees()
                                        ? "One curve: the dashed ones lie upon the run inside the"
                                                + " simulator."
                                        : "The curves are not one: this is a fault of the"
                                                + " simulator."),
                        hashes()));
    }

    private boolean agrees() {
        return lockstep.stream().allMatch(trace -> trace.firstDifference(local).isEmpty());
    }

    private String summary() {
        double apart =
                asynchronous.stream().mapToDouble(t -> t.largestDifference(local)).max().orElse(0);
        return String.format(
                Locale.ROOT,
                "Five clients that do not wait for the simulator, nor it for them, end up to %.2g m"
                        + " away from the run inside the simulator, differently each time, as the"
                        + " thesis found. In lock-step, %d of %d runs are that run bit for bit: the"
                        + " state's hash is %016x in each.",
                apart,
                lockstep.stream().filter(t -> t.firstDifference(local).isEmpty()).count(),
                lockstep.size(),
                local.lastHash());
    }

    private Section section(
            String heading, String what, List<Trace> traces, String title, String reading) {
        List<Curve> curves = new ArrayList<>();
        curves.add(Curve.line(local.name(), local.distances()));
        for (Trace trace : traces) {
            curves.add(new Curve(trace.name(), Mark.DASHED, trace.distances()));
        }
        return Section.of(
                heading,
                new Text(what),
                new Chart(title, "world time (s)", "distance (m)", curves, reading));
    }

    private Section hashes() {
        List<List<String>> rows = new ArrayList<>();
        rows.add(row(local));
        asynchronous.forEach(trace -> rows.add(row(trace)));
        lockstep.forEach(trace -> rows.add(row(trace)));
        return Section.of(
                "Hashes of the state",
                new Table(
                        List.of(
                                "run",
                                "hash at the end",
                                "first step that differs from run 1",
                                "largest difference (m)"),
                        rows,
                        "A hash covers the time, the position, the orientation and the momenta of"
                            + " all spheres to the last bit; it is compared after every step."));
    }

    private List<String> row(Trace trace) {
        int first = trace.firstDifference(local).orElse(0);
        return List.of(
                trace.name(),
                String.format(Locale.ROOT, "%016x", trace.lastHash()),
                first == 0 ? "none" : Integer.toString(first),
                String.format(Locale.ROOT, "%.3g", trace.largestDifference(local)));
    }
}
