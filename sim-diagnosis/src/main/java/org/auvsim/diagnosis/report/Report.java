package org.auvsim.diagnosis.report;

import org.auvsim.diagnosis.result.Approximation;
import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.plot.page.ReportPage;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** A diagnosis as a folder of files. */
public final class Report {
    private static final String PREDICTIONS = "predictions";
    private static final String RESIDUALS = "residuals";

    /** The file of a model that does not explain the runs but is much nearer to them. */
    static final String APPROXIMATE = "approximate-scenario.xml";

    private Report() {}

    /**
     * Writes {@code report.html}, {@code diagnosis.json}, {@code extended-scenario.xml}, for each
     * held-out run {@code predictions/RUN.csv}, and for each run {@code residuals/RUN.csv}; and
     * {@code approximate-scenario.xml} if nothing explains the runs but something comes near. Each
     * file appears whole or not at all, those of an earlier report are replaced, and {@code
     * diagnosis.json} comes last.
     *
     * @return the path of {@code report.html}
     * @throws IOException if a file cannot be written
     */
    public static Path write(Diagnosis diagnosis, Path folder) throws IOException {
        List<NamedRun> runs = NamedRun.of(diagnosis.runs());
        Path predictions = emptied(folder.resolve(PREDICTIONS));
        Path residuals = emptied(folder.resolve(RESIDUALS));
        for (NamedRun file : runs) {
            DiagnosedRun run = file.run();
            if (run.isHeldOut()) {
                WholeFile.write(
                        predictions.resolve(file.name()), out -> RunTables.prediction(run, out));
            }
            WholeFile.write(residuals.resolve(file.name()), out -> RunTables.residuals(run, out));
        }
        WholeFile.write(
                folder.resolve("extended-scenario.xml"),
                out -> out.write(ExtendedScenario.text(diagnosis)));
        Path approximate = folder.resolve(APPROXIMATE);
        Files.deleteIfExists(approximate);
        Optional<Approximation> nearer = diagnosis.conclusion().approximation();
        if (nearer.isPresent()) {
            String text = ExtendedScenario.text(diagnosis, nearer.get());
            WholeFile.write(approximate, out -> out.write(text));
        }
        Path page = folder.resolve("report.html");
        WholeFile.write(page, out -> out.write(ReportPage.html(Page.of(diagnosis))));
        WholeFile.write(
                folder.resolve("diagnosis.json"),
                out -> out.write(DiagnosisJson.text(diagnosis, runs)));
        return page;
    }

    /** A folder of the report's own, without the tables of an earlier one. */
    private static Path emptied(Path folder) throws IOException {
        Files.createDirectories(folder);
        try (DirectoryStream<Path> tables = Files.newDirectoryStream(folder, "*.csv")) {
            for (Path table : tables) {
                Files.delete(table);
            }
        }
        return folder;
    }
}
