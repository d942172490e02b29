package org.auvsim.cli;

import org.auvsim.cli.report.FaultReport;

import picocli.AutoComplete.GenerateCompletion;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

import java.io.PrintWriter;
import java.nio.file.Path;

/** The {@code auvsim} command: each subcommand is a class beside this one. */
@Command(
        name = "auvsim",
        description = "Simulates robots in three dimensions, corrected by what they measure.",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        scope = CommandLine.ScopeType.INHERIT,
        synopsisSubcommandLabel = "<command>",
        commandListHeading = "%nCommands:%n",
        footer = "%nA command explains itself with: auvsim <command> --help",
        subcommands = {
            Demo.class,
            Serve.class,
            Replay.class,
            Run.class,
            Validate.class,
            Vehicle.class,
            Watch.class,
            Admin.class,
            Feed.class,
            Export.class,
            Mirror.class,
            Diagnose.class,
            Bench.class,
            Experiment.class,
            CommandLine.HelpCommand.class,
            GenerateCompletion.class
        })
public final class Auvsim implements Runnable {
    @Spec private CommandSpec spec;

    private Auvsim() {}

    /** Runs one command and ends the process: 0 done, 2 wrong input, 1 a fault of our own. */
    public static void main(String[] arguments) {
        System.exit(commandLine(Path.of(System.getProperty("java.io.tmpdir"))).execute(arguments));
    }

    /** The command line, whose reports of faults of our own go to files in {@code reports}. */
    static CommandLine commandLine(Path reports) {
        return OptionValues.readBy(new CommandLine(new Auvsim()))
                .setCaseInsensitiveEnumValuesAllowed(true)
                .setParameterExceptionHandler(Auvsim::explain)
                .setExecutionExceptionHandler(new FaultReport(reports));
    }

    @Override
    public void run() {
        throw new ParameterException(spec.commandLine(), "Say which command to run.");
    }

    private static int explain(ParameterException e, String[] arguments) {
        PrintWriter err = e.getCommandLine().getErr();
        err.println(OptionValues.refusal(e).orElse(e.getMessage()));
        CommandLine.UnmatchedArgumentException.printSuggestions(e, err);
        err.printf("Try '%s --help'.%n", e.getCommandLine().getCommandSpec().qualifiedName());
        err.flush();
        return CommandLine.ExitCode.USAGE;
    }
}
