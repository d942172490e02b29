package org.auvsim.cli;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;

import org.auvsim.cli.demo.Demonstration;
import org.auvsim.cli.report.UserError;
import org.auvsim.server.net.TransportException;
import org.slf4j.LoggerFactory;

import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.util.concurrent.Callable;

/** {@code auvsim demo}: what the simulator is for, in a minute. */
@Command(
        name = "demo",
        description = {
            "Flies a robot that the model gets wrong, and corrects the model by its feedback.",
            "Starts a server on a free loopback port and connects a physical robot over TCP:"
                    + " it flies its simulated self by the commands that it gets itself, really"
                    + " moves differently, and sends the positions that it measures."
        })
final class Demo implements Callable<Integer> {
    @Spec private CommandSpec spec;

    @Option(
            names = "--out",
            paramLabel = "FOLDER",
            defaultValue = "auvsim-demo",
            description = "Where demo.png and demo.html go (default: ${DEFAULT-VALUE}).")
    private Path folder = Path.of("auvsim-demo");

    @Override
    public Integer call() {
        // Clients that come and go would interrupt the table.
        ((Logger) LoggerFactory.getLogger("org.auvsim.server")).setLevel(Level.WARN);
        try {
            new Demonstration(spec.commandLine().getOut()).run(folder);
            return ExitCode.OK;
        } catch (FileSystemException e) {
            throw new UserError(
                    "Cannot write to the folder '%s': name another one with --out."
                            .formatted(folder),
                    e);
        } catch (IOException | TransportException e) {
            throw new UserError("The demonstration ended early: " + e.getMessage(), e);
        }
    }
}
