package org.auvsim.cli;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.cli.report.UserError;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.experiments.vehicle.VehicleSheet;

import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;

/** {@code auvsim vehicle}. */
@Command(
        name = "vehicle",
        description =
                "Prints what the numbers of a vehicle say of it: masses, stability, speeds, and"
                        + " what looks wrong.",
        footer = {
            "",
            "Speeds and stability are found by trying the vehicle in still, deep water.",
            "",
            "Example: auvsim vehicle examples/vehicles/remus100.xml"
        })
final class Vehicle implements Callable<Integer> {
    @Spec private CommandSpec spec;

    @Parameters(paramLabel = "FILE", description = "A scenario.")
    private Path file;

    @Option(
            names = "--body",
            paramLabel = "NAME",
            description = "Which world object; by default the first one that moves.")
    private Optional<String> body = Optional.empty();

    @Override
    public Integer call() throws DocumentException {
        PrintWriter out = spec.commandLine().getOut();
        Scenario scenario = ScenarioFile.load(file, spec.commandLine().getErr());
        try {
            out.print(VehicleSheet.of(choose(scenario.worldObject())));
        } catch (IllegalArgumentException e) {
            throw new UserError(file + ": " + e.getMessage(), e);
        }
        out.flush();
        return ExitCode.OK;
    }

    private WorldObjectDefinition choose(List<WorldObjectDefinition> objects) {
        return objects.stream()
                .filter(o -> body.map(o.name()::equals).orElse(!o.fixed()))
                .findFirst()
                .orElseThrow(
                        () ->
                                new IllegalArgumentException(
                                        "there is no body %s; there are %s"
                                                .formatted(
                                                        body.map(name -> "'" + name + "'")
                                                                .orElse("that moves"),
                                                        objects.stream()
                                                                .map(WorldObjectDefinition::name)
                                                                .toList())));
    }
}
