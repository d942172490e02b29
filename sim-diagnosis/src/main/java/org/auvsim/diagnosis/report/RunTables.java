package org.auvsim.diagnosis.report;

import de.siegmar.fastcsv.writer.CsvWriter;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.Reading;
import org.auvsim.server.feedback.RigidMotion;

import java.io.IOException;
import java.io.Writer;
import java.util.ArrayList;
import java.util.List;
import java.util.StringJoiner;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;

/** A run's tables as CSV: metres, seconds, radians, world axes. */
final class RunTables {
    private RunTables() {}

    /** How a channel's three numbers are called, as in the files that are read. */
    private static final List<String> AXES = List.of("x", "y", "z");

    /** How the body moves by the model with what was found. */
    static void prediction(DiagnosedRun run, Writer out) throws IOException {
        CsvWriter csv = CsvWriter.builder().build(out);
        csv.writeRecord("t", "x", "y", "z", "qw", "qx", "qy", "qz");
        for (int k = 0; k < Math.min(run.run().size(), run.after().size()); k++) {
            RigidMotion motion = run.after().get(k);
            Vec3 p = motion.position();
            Quat q = motion.orientation();
            row(
                    csv,
                    DoubleStream.of(
                            run.run().time(k), p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()));
        }
        csv.flush();
    }

    /**
     * What was measured less what the model tells, as it was believed and with what was found:
     * columns {@code position.x.before}, {@code position.x.after} and so on; of orientations the
     * rotation vector. Fields are empty where nothing was measured or simulated. The last column
     * has the names of the numbers, as {@code position.x}, that are left out of the errors told.
     */
    static void residuals(DiagnosedRun of, Writer out) throws IOException {
        MeasuredRun run = of.run();
        CsvWriter csv = CsvWriter.builder().build(out);
        List<Channel> channels = Stream.of(Channel.values()).filter(run::measures).toList();
        csv.writeRecord(header(channels));
        Residuals before = new Residuals(run, of.before());
        Residuals after = new Residuals(run, of.after());
        for (int k = 0; k < run.size(); k++) {
            DoubleStream.Builder numbers = DoubleStream.builder().add(run.time(k));
            for (Channel channel : channels) {
                for (int axis = 0; axis < AXES.size(); axis++) {
                    numbers.add(number(before, channel, k, axis));
                    numbers.add(number(after, channel, k, axis));
                }
            }
            List<String> cells = cells(numbers.build());
            cells.add(uncounted(of, k));
            csv.writeRecord(cells);
        }
        csv.flush();
    }

    private static String uncounted(DiagnosedRun of, int sample) {
        StringJoiner names = new StringJoiner(" ");
        for (Channel channel : of.uncounted().isEmpty() ? new Channel[0] : Channel.values()) {
            for (int axis = 0; axis < AXES.size(); axis++) {
                if (of.uncounted().contains(new Reading(channel, sample, axis))) {
                    names.add("%s.%s".formatted(Names.of(channel), AXES.get(axis)));
                }
            }
        }
        return names.toString();
    }

    private static List<String> header(List<Channel> channels) {
        List<String> header = new ArrayList<>(List.of("t"));
        for (Channel channel : channels) {
            for (String axis : AXES) {
                header.add("%s.%s.before".formatted(Names.of(channel), axis));
                header.add("%s.%s.after".formatted(Names.of(channel), axis));
            }
        }
        header.add("left_out");
        return header;
    }

    private static double number(Residuals residuals, Channel channel, int sample, int axis) {
        return sample < residuals.size()
                ? residuals.of(channel, sample).component(axis)
                : Double.NaN;
    }

    private static void row(CsvWriter csv, DoubleStream numbers) {
        csv.writeRecord(cells(numbers));
    }

    private static List<String> cells(DoubleStream numbers) {
        return numbers.mapToObj(n -> Double.isFinite(n) ? Double.toString(n) : "")
                .collect(Collectors.toCollection(ArrayList::new));
    }
}
