package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.core.entity.Actuator;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.diagnosis.run.Axes;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.NavigableSet;
import java.util.TreeSet;
import java.util.stream.Collectors;

/**
 * Reads the run, or the runs between gaps, of one recording: feedback messages are what was
 * measured; levels of propulsors, angles of fins and forces are what was commanded.
 */
final class RecordedRuns {
    private final Path file;
    private final String name;
    private final MeasuredBody body;
    private final AuvsmlMapper mapper;
    private final KnownOfRun known;
    private final List<String> notices = new ArrayList<>();
    private Doubt doubt = Doubt.NONE;

    RecordedRuns(Path file, String name, MeasuredBody body, AuvsmlMapper mapper, KnownOfRun known) {
        this.file = file;
        this.name = name;
        this.body = body;
        this.mapper = mapper;
        this.known = known;
    }

    /**
     * The runs.
     *
     * @throws DocumentException if it cannot be read or nobody sent feedback for the body
     */
    List<MeasuredRun> read() throws DocumentException {
        RecordedFeedback feedback = new RecordedFeedback(file, mapper);
        WorldObject recorded = feedback.object(body.name());
        long id = recorded.id();
        RecordedRows all = all(feedback, id);
        long each = (all.times() + RunParts.MOST - 1) / RunParts.MOST;
        List<Actuator> told = body.told(all.names());
        RecordedRows rows = new RecordedRows(id, told.stream().map(Actuator::name).toList(), each);
        RecordedPushes pushes = new RecordedPushes(id);
        feedback.tell(
                (time, message) -> {
                    rows.sent(time, message);
                    pushes.sent(time, message);
                });
        tell(feedback, rows, each);
        tellOf(body.leftAlone(recorded.definition(), all.names()));
        return runs(rows, told, pushes);
    }

    /** Behaviors are those of the scenario, which may lack what directed the recorded body. */
    private void tellOf(List<Actuator> leftAlone) {
        if (leftAlone.isEmpty()) {
            return;
        }
        String names =
                leftAlone.stream()
                        .map(Actuator::name)
                        .collect(Collectors.joining("', '", "'", "'"));
        notices.add(
                "%s: a schedule or another behavior of the recorded scenario directed %s, and none of the scenario given does: %s what that states; add what directed %s to the scenario"
                        .formatted(
                                file,
                                names,
                                leftAlone.size() == 1 ? "it holds" : "they hold",
                                leftAlone.size() == 1 ? "it" : "them"));
        doubt = Doubt.LASTING;
    }

    /** Whether the commands may be other ones than it seems. */
    Doubt doubt() {
        return doubt;
    }

    /** What was done to the data, and what could not be used. */
    List<String> notices() {
        return notices;
    }

    /** How much there is of it. */
    private RecordedRows all(RecordedFeedback feedback, long id) throws DocumentException {
        RecordedRows all = new RecordedRows(id, List.of(), Long.MAX_VALUE);
        feedback.tell(all);
        if (all.times() < MeasuredRun.FEWEST) {
            throw new DocumentException(
                    "%s: expected feedback for '%s' at %d instants at least, but found %d"
                            .formatted(file, body.name(), MeasuredRun.FEWEST, all.times()));
        }
        return all;
    }

    private void tell(RecordedFeedback feedback, RecordedRows rows, long each) {
        feedback.replaced()
                .ifPresent(
                        time ->
                                notices.add(
                                        "%s: at %s s the world was replaced; what follows is left out"
                                                .formatted(file, Figures.shown(time, 9))));
        if (rows.leftOut() > 0) {
            notices.add(
                    "%s: parts of %d measurements are left out: places in body axes are relative to a state that no recording has, and velocities are taken in one kind of axes"
                            .formatted(file, rows.leftOut()));
        }
        if (each > 1) {
            notices.add(
                    "%s: of %d measured instants one in %d is taken"
                            .formatted(file, rows.times(), each));
        }
    }

    private List<MeasuredRun> runs(RecordedRows rows, List<Actuator> told, RecordedPushes pushes)
            throws DocumentException {
        RowSample samples =
                new RowSample(
                        Axes.ENU,
                        rows.frame(),
                        rows.frame(),
                        Frame.WORLD,
                        body.usualOrientation(),
                        Map.of());
        Extent extent =
                new Extent(rows.measured().size(), rows.told().size(), interval(rows.measured()));
        RunParts parts =
                new RunParts(
                        name,
                        Source.of(file),
                        told.stream().map(Actuator::name).toList(),
                        samples,
                        extent,
                        run -> {
                            known.tell(run);
                            pushes.forces().forEach(run::force);
                        });
        double[] levels = told.stream().mapToDouble(Actuator::command).toArray();
        add(rows, levels, parts);
        List<MeasuredRun> runs = parts.runs();
        notices.addAll(parts.notices());
        return runs;
    }

    private static double interval(Map<Double, double[]> measured) {
        double[] times = measured.keySet().stream().mapToDouble(Double::doubleValue).toArray();
        double[] intervals = new double[times.length - 1];
        for (int i = 0; i < intervals.length; i++) {
            intervals[i] = times[i + 1] - times[i];
        }
        Arrays.sort(intervals);
        return intervals[intervals.length / 2];
    }

    /** All rows in order of time; commands from before the first measurement are its own. */
    private static void add(RecordedRows rows, double[] levels, RunParts parts) {
        double begin = rows.measured().firstKey();
        rows.told().headMap(begin, true).values().forEach(told -> hold(told, levels));
        NavigableSet<Double> times = new TreeSet<>(rows.measured().keySet());
        times.addAll(rows.told().tailMap(begin, false).keySet());
        for (double time : times) {
            double[] told = rows.told().getOrDefault(time, new double[0]);
            hold(time > begin ? told : new double[0], levels);
            boolean isMeasured = rows.measured().containsKey(time);
            double[] numbers =
                    rows.measured().getOrDefault(time, new double[Slots.COMMANDS + levels.length]);
            System.arraycopy(levels, 0, numbers, Slots.COMMANDS, levels.length);
            parts.add(time, numbers, isMeasured, told.length > 0);
        }
    }

    private static void hold(double[] told, double[] levels) {
        for (int i = 0; i < told.length; i++) {
            levels[i] = Double.isNaN(told[i]) ? levels[i] : told[i];
        }
    }
}
