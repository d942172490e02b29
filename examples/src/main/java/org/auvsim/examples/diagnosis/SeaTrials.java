package org.auvsim.examples.diagnosis;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.reading.RunFiles;
import org.auvsim.diagnosis.reading.RunReader;
import org.auvsim.diagnosis.report.Report;
import org.auvsim.diagnosis.result.Diagnosis;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/** Measured runs against the model of a vehicle. */
public final class SeaTrials {
    private static final long SEED = 1;

    private SeaTrials() {}

    /**
     * Diagnoses runs, and writes the report beside them.
     *
     * @param body the name of the vehicle in the scenario
     * @throws DocumentException if a file cannot be used
     * @throws IOException if the report cannot be written
     */
    public static Diagnosis diagnose(Path scenario, String body, List<Path> fit, List<Path> heldOut)
            throws DocumentException, IOException {
        AuvsmlMapper mapper = AuvsmlMapper.load(SeaTrials.class.getClassLoader());
        BelievedModel model =
                new BelievedModel(
                        ScenarioLoader.load(SeaTrials.class.getClassLoader()).load(scenario), body);
        RunFiles runs =
                RunFiles.read(new RunReader(model, ColumnMapping.USUAL, mapper), fit, heldOut);
        Diagnosis diagnosis =
                new Investigation(
                                model,
                                runs.fit(),
                                runs.heldOut(),
                                Library.of(model, runs.fit()),
                                SEED,
                                Progress.SILENT)
                        .diagnose();
        Report.write(diagnosis, scenario.resolveSibling("report"));
        return diagnosis;
    }
}
