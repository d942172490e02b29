package org.auvsim.diagnosis.reading;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.function.IntFunction;

/** A body with a thruster, a fin and a force, and files that were measured of it. */
final class Rov {
    static final ClassLoader LOADER = Rov.class.getClassLoader();
    static final AuvsmlMapper MAPPER = AuvsmlMapper.load(LOADER);

    static final String SCENARIO =
            """
            <scenario>
              <time-step delta="0.1"/>
              <uniform-current id="70" name="Tide"><velocity x="0" y="0" z="0"/></uniform-current>
              <world-object id="1" name="Rov" mass="30">
                <box><size x="0.6" y="0.4" z="0.3"/></box>
                <orientation w="0.7071067811865476" x="0" y="0" z="0.7071067811865476"/>
                <force name="push"><vector x="0" y="3" z="4"/></force>
                <propulsor name="main" maximum-thrust="20"/>
                <fin name="rudder" area="0.01" lift-slope="2">
                  <span x="0" y="0" z="1"/>
                </fin>
              </world-object>
              <world-object name="Buoy" mass="1"><sphere radius="0.1"/>
                <position x="5" y="0" z="0"/></world-object>
            </scenario>
            """;

    private Rov() {}

    static BelievedModel model() {
        return model(SCENARIO);
    }

    private static BelievedModel model(String scenario) {
        try {
            return new BelievedModel(
                    ScenarioLoader.load(LOADER).parse(scenario.getBytes(UTF_8)), "Rov");
        } catch (AuvsmlException e) {
            throw new IllegalStateException(e);
        }
    }

    /** A scenario with one more component of the body. */
    static String with(String component) {
        return SCENARIO.replaceFirst("</world-object>", component + "</world-object>");
    }

    /** What is read of a text with a scenario of its own. */
    static RunFile read(Path folder, String scenario, String text)
            throws IOException, DocumentException {
        return reader(scenario).read(write(folder.resolve("run.csv"), text));
    }

    /** A reader for a scenario of its own. */
    static RunReader reader(String scenario) {
        return new RunReader(model(scenario), ColumnMapping.USUAL, MAPPER);
    }

    /** A reader with a mapping. */
    static RunReader reader(ColumnMapping mapping) {
        return new RunReader(model(), mapping, MAPPER);
    }

    /** What is read of a text. */
    static RunFile read(Path folder, ColumnMapping mapping, String text)
            throws IOException, DocumentException {
        return reader(mapping).read(write(folder.resolve("run.csv"), text));
    }

    static MeasuredRun run(Path folder, ColumnMapping mapping, String text)
            throws IOException, DocumentException {
        return read(folder, mapping, text).runs().getFirst();
    }

    static Path write(Path file, String text) throws IOException {
        return Files.writeString(file, text);
    }

    /** A file of 6 s whose numbers differ from those of every other seed. */
    static Path dive(Path file, int seed) throws IOException {
        return write(file, rows("x,main,rudder", 60, i -> seed + i + ",0,0"));
    }

    /** A header and so many rows; each begins with a time, 0.1 s after the one before. */
    static String rows(String header, int count, IntFunction<String> cells) {
        StringBuilder text = new StringBuilder("t,").append(header).append('\n');
        for (int i = 0; i < count; i++) {
            text.append(String.format(Locale.ROOT, "%.1f,", 0.1 * i));
            text.append(cells.apply(i)).append('\n');
        }
        return text.toString();
    }
}
