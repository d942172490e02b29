package org.auvsim.diagnosis.measured;

import org.auvsim.auvsml.AuvsmlException;
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
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/**
 * A folder of measured data, which is no part of the project, and the example of the same name,
 * which has the model and the columns for it.
 */
final class DataSet {
    /** Names the folder that has those of the data sets. */
    static final String PROPERTY = "auvsim.measuredData";

    private static final ClassLoader LOADER = DataSet.class.getClassLoader();
    private static final AuvsmlMapper MAPPER = AuvsmlMapper.load(LOADER);
    private static final Path ROOT = Path.of("..");
    private static final long SEED = 1;

    private final Path data;
    private final Path example;

    private DataSet(Path data, Path example) {
        this.data = data;
        this.example = example;
    }

    /** The one of a name; a relative folder is one of the repository's root. */
    static DataSet named(String name) {
        String stated = System.getProperty(PROPERTY, "");
        Path folder = ROOT.resolve(stated).resolve(name);
        if (stated.isEmpty() || !Files.isDirectory(folder)) {
            throw new IllegalStateException(
                    "%s is '%s', which has no folder %s; give the folder of the measured data (docs/measured-data.md)"
                            .formatted(PROPERTY, stated, name));
        }
        return new DataSet(folder, ROOT.resolve("examples/measured-data").resolve(name));
    }

    /** A file of the data. */
    Path file(String name) {
        return data.resolve(name);
    }

    /** The files of the data whose names begin so, by name. */
    List<Path> filesOf(String prefix) throws IOException {
        try (Stream<Path> files = Files.list(data)) {
            return files.filter(file -> file.getFileName().toString().startsWith(prefix))
                    .sorted()
                    .toList();
        }
    }

    /** A file of the example. */
    Path example(String name) {
        return example.resolve(name);
    }

    /** The body of a scenario of the example. */
    BelievedModel model(String scenario, String body) {
        return model(example.resolve(scenario), body);
    }

    /** The body of a scenario in a file. */
    static BelievedModel model(Path scenario, String body) {
        try {
            byte[] text = Files.readAllBytes(scenario);
            return new BelievedModel(ScenarioLoader.load(LOADER).parse(text), body);
        } catch (IOException | AuvsmlException e) {
            throw new IllegalStateException(e);
        }
    }

    /** What runs say of a model. */
    static Diagnosis diagnosis(
            BelievedModel model, List<MeasuredRun> fit, List<MeasuredRun> heldOut) {
        return new Investigation(model, fit, heldOut, Library.of(model, fit), SEED, Progress.SILENT)
                .diagnose();
    }

    /** Runs in files of the data, with columns as the example states; none held out: by default. */
    static RunFiles runs(BelievedModel model, Path columns, List<Path> fit, List<Path> heldOut)
            throws DocumentException {
        return RunFiles.read(reader(model, columns), fit, heldOut);
    }

    /** A reader of runs with columns as a mapping states. */
    static RunReader reader(BelievedModel model, Path columns) throws DocumentException {
        return new RunReader(model, RunReader.mapping(columns, MAPPER), MAPPER);
    }

    /** The same, diagnosed. */
    Diagnosis diagnosis(BelievedModel model, String columns, List<Path> fit, List<Path> heldOut)
            throws DocumentException {
        RunFiles runs = runs(model, example.resolve(columns), fit, heldOut);
        return diagnosis(model, runs.fit(), runs.heldOut()).noticing(runs.notices());
    }

    /** The same of what is measured until a time (s) of each run. */
    Diagnosis diagnosis(
            BelievedModel model, String columns, double until, List<Path> fit, List<Path> heldOut)
            throws DocumentException {
        ColumnMapping mapping = RunReader.mapping(example.resolve(columns), MAPPER);
        RunReader reader = new RunReader(model, mapping, MAPPER).between(0, until);
        RunFiles runs = RunFiles.read(reader, fit, heldOut);
        return diagnosis(model, runs.fit(), runs.heldOut()).noticing(runs.notices());
    }
}
