package org.auvsim.cli;

import org.auvsim.cli.extension.Extensions;
import org.auvsim.cli.report.FaultReport;

import picocli.AutoComplete.GenerateCompletion;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExecutionException;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.Spec;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;

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
            View.class,
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

    @Option(
            names = "--extensions",
            paramLabel = "DIR",
            scope = CommandLine.ScopeType.INHERIT,
            description =
                    "A folder of jars with effects, messages, feedback processors and others of"
                        + " your own; those in the folder ~/.auvsim/extensions are always taken.")
    private Optional<Path> extensions = Optional.empty();

    private Auvsim() {}

    /** Runs one command and ends the process: 0 done, 2 wrong input, 1 a fault of our own. */
    public static void main(String[] arguments) {
        Path reports = Path.of(System.getProperty("java.io.tmpdir"));
        Path home = Path.of(System.getProperty("user.home"));
        System.exit(commandLine(reports, home).execute(arguments));
    }

    /**
     * The command line, whose reports of faults of our own go to files in {@code reports}.
     *
     * @param home the user's folder, in which extensions may be
     */
    static CommandLine commandLine(Path reports, Path home) {
        Auvsim auvsim = new Auvsim();
        CommandLine line = new CommandLine(auvsim);
        // Its options take many files: a misspelt option is none of them.
        Objects.requireNonNull(line.getSubcommands().get("diagnose"))
                .setUnmatchedOptionsAllowedAsOptionParameters(false);
        return OptionValues.readBy(line)
                .setExecutionStrategy(parsed -> auvsim.execute(parsed, home))
                .setCaseInsensitiveEnumValuesAllowed(true)
                .setParameterExceptionHandler(Auvsim::explain)
                .setExecutionExceptionHandler(new FaultReport(reports));
    }

    @Override
    public void run() {
        throw new ParameterException(spec.commandLine(), "Say which command to run.");
    }

    private int execute(ParseResult parsed, Path home) {
        Integer help = CommandLine.executeHelpRequest(parsed);
        if (help != null) {
            return help;
        }
        try {
            return Extensions.in(home, extensions)
                    .during(() -> new CommandLine.RunLast().execute(parsed));
        } catch (ParameterException | ExecutionException e) {
            throw e;
        } catch (Exception e) {
            throw new ExecutionException(spec.commandLine(), "auvsim", e);
        }
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
