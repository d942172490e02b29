package org.auvsim.cli;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.auvsml.mapping.ContextClasses;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;

/** A scenario that a command is given, and what the user has to know of it. */
final class ScenarioFile {
    private ScenarioFile() {}

    /** The scenario in a file; its notices are printed. */
    static Scenario load(Path file, PrintWriter err) throws DocumentException {
        Scenario scenario = ScenarioLoader.load(ContextClasses.loader()).load(file);
        print(file, scenario.notices(), err);
        return scenario;
    }

    /** A line for each notice on a file. */
    static void print(Path file, List<String> notices, PrintWriter err) {
        notices.forEach(notice -> err.printf("%s: notice: %s%n", file, notice));
        err.flush();
    }
}
