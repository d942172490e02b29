package org.auvsim.cli;

import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.Validation;
import org.auvsim.auvsml.mapping.ContextClasses;
import org.auvsim.auvsml.mapping.MessageCatalogue;

import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;

/** {@code auvsim validate}. */
@Command(
        name = "validate",
        description =
                "Checks scenarios, files of messages, and documents of measured runs (run,"
                        + " column-mapping): ok, or every fault with line and column.",
        footer = {"", "The exit code is 2 if there is a fault."})
final class Validate implements Callable<Integer> {
    @Spec private CommandSpec spec;

    @Parameters(
            arity = "1..*",
            paramLabel = "FILE",
            description = "A scenario, messages, or a document of measured runs.")
    private List<Path> files = List.of();

    @Override
    public Integer call() throws DocumentException {
        MessageCatalogue catalogue = MessageCatalogue.load(ContextClasses.loader());
        Validation validation = new Validation(catalogue);
        boolean ok = true;
        for (Path file : files) {
            List<Fault> faults = validation.faults(file);
            ok &= isOk(file, faults);
            if (faults.isEmpty()) {
                ScenarioFile.print(file, validation.notices(file), spec.commandLine().getErr());
            }
        }
        return ok ? ExitCode.OK : ExitCode.USAGE;
    }

    private boolean isOk(Path file, List<Fault> faults) {
        PrintWriter out = spec.commandLine().getOut();
        for (Fault fault : faults) {
            out.println(fault.in(file));
        }
        if (faults.isEmpty()) {
            out.printf("%s: ok%n", file);
        }
        out.flush();
        return faults.isEmpty();
    }
}
