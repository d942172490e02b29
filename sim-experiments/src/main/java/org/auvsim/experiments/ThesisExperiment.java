package org.auvsim.experiments;

import org.auvsim.plot.page.Report;

import java.io.IOException;
import java.util.Optional;

/** Something that the thesis tried and reported (chapter 8), tried again. */
@FunctionalInterface
public interface ThesisExperiment {
    /**
     * Runs it.
     *
     * @return what came of it; empty if it was told to stop
     * @throws IOException if a client of the simulation loses its server
     */
    Optional<Report> run(Conduct conduct) throws IOException;
}
