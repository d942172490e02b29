package org.auvsim.cli.report;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.document.DocumentException;

import picocli.CommandLine;
import picocli.CommandLine.IExecutionExceptionHandler;
import picocli.CommandLine.ParseResult;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;

/** Says in one sentence why a command failed; the trace of a fault of our own goes to a file. */
public final class FaultReport implements IExecutionExceptionHandler {
    /**
     * A fault of the software, as BSD's {@code sysexits.h} has it: 1 may be what a command says.
     */
    private static final int FAULT = 70;

    private final Path folder;

    /** Writes its reports to {@code folder}. */
    public FaultReport(Path folder) {
        this.folder = folder;
    }

    @Override
    public int handleExecutionException(Exception e, CommandLine command, ParseResult parsed)
            throws IOException {
        PrintWriter err = command.getErr();
        if (isTheUsers(e)) {
            err.println(e.getMessage());
            err.flush();
            return CommandLine.ExitCode.USAGE;
        }
        Path report = Files.createTempFile(folder, "auvsim-fault-", ".txt");
        try (var out = new PrintWriter(Files.newBufferedWriter(report, UTF_8))) {
            e.printStackTrace(out);
        }
        err.printf("auvsim failed by a fault of its own; please report %s%n", report);
        err.flush();
        return FAULT;
    }

    private static boolean isTheUsers(Exception e) {
        return e instanceof UserError
                || e instanceof ConnectionException
                || e instanceof DocumentException;
    }
}
