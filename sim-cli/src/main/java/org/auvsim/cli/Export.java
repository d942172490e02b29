package org.auvsim.cli;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.recording.Reach;
import org.auvsim.auvsml.document.recording.RecordingReader;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.mapping.ContextClasses;
import org.auvsim.cli.export.ExportFormat;
import org.auvsim.cli.export.RecordingExport;
import org.auvsim.cli.export.Table;
import org.auvsim.cli.report.FileTrouble;
import org.auvsim.cli.report.UserError;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;

/** {@code auvsim export}. */
@Command(
        name = "export",
        description = "Writes what a recording holds as tables.",
        footer = {
            "",
            "The tables are movements, collisions, feedback, messages and sessions: with csv a file"
                    + " each in the folder of --out, with sqlite in one database. docs/recording.md"
                    + " describes their columns.",
            "A recording that was cut off is exported as far as it goes.",
            "",
            "Example: auvsim export run.auvsml.gz --format sqlite --out run.db"
        })
final class Export implements Callable<Integer> {
    @Spec private CommandSpec spec;

    @Parameters(paramLabel = "FILE", description = "A recording.")
    private Path file;

    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            required = true,
            description = "csv or sqlite.")
    private ExportFormat format = ExportFormat.CSV;

    @Option(
            names = "--out",
            paramLabel = "PATH",
            required = true,
            description = "The folder for CSV files, or the database's file.")
    private Path out = Path.of("");

    @Option(names = "--force", description = "Writes over files that are there.")
    private boolean force;

    @Override
    public Integer call() throws DocumentException {
        RecordingExport export = new RecordingExport(format, out);
        requireWritable(export);
        AuvsmlMapper mapper = AuvsmlMapper.load(ContextClasses.loader());
        try (RecordingReader recording = RecordingReader.open(file, mapper)) {
            tell(write(export, recording, mapper), recording.reach());
        } catch (IOException e) {
            throw FileTrouble.reading(file, e);
        }
        return 0;
    }

    private void requireWritable(RecordingExport export) {
        if (destroys(export)) {
            throw new UserError(
                    "%s is the recording that is read; name another place by --out."
                            .formatted(file));
        }
        export.obstacle()
                .ifPresent(
                        what -> {
                            throw new UserError(
                                    "--format %s; name another place by --out.".formatted(what));
                        });
        if (!force && export.existing().isPresent()) {
            throw new UserError(
                    "%s exists; name another place by --out, or write over it with --force."
                            .formatted(export.existing().get()));
        }
    }

    private boolean destroys(RecordingExport export) {
        try {
            return export.destroys(file);
        } catch (IOException e) {
            throw FileTrouble.reading(file, e);
        }
    }

    private Map<Table, Long> write(
            RecordingExport export, RecordingReader recording, AuvsmlMapper mapper)
            throws DocumentException {
        try {
            return export.write(recording, mapper);
        } catch (IOException e) {
            throw FileTrouble.writing(out, e);
        }
    }

    private void tell(Map<Table, Long> rows, Reach reach) {
        if (!reach.isWhole()) {
            PrintWriter err = spec.commandLine().getErr();
            err.printf(
                    "%s: notice: it ends at step %d (%s s): %s.%n",
                    file, reach.step(), reach.timestamp(), reach.reason());
            err.flush();
        }
        PrintWriter to = spec.commandLine().getOut();
        to.printf(
                "%s written to %s%n",
                rows.entrySet().stream()
                        .map(
                                table ->
                                        "%s: %d"
                                                .formatted(
                                                        table.getKey().sqlName(), table.getValue()))
                        .collect(Collectors.joining(", ")),
                out);
        to.flush();
    }
}
