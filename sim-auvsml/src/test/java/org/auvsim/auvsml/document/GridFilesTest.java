package org.auvsim.auvsml.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.core.field.GriddedCurrent;
import org.auvsim.core.math.Numbers;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

class GridFilesTest {
    private static final String SCENARIO =
            """
            <scenario>
              <gridded-current id="1" name="bay"
                  file="bay.csv"/>
            </scenario>
            """;

    @TempDir private Path folder;

    private final ScenarioLoader loader = ScenarioLoader.load(GridFilesTest.class.getClassLoader());

    private Path scenario(String csv) throws IOException {
        Files.writeString(folder.resolve("bay.csv"), csv);
        return Files.writeString(folder.resolve("bay.xml"), SCENARIO);
    }

    /** Rows and columns in any order; the scenario needs its file no more. */
    @Test
    void aFileOfPointsBecomesTheCurrentsNumbers() throws Exception {
        Path file =
                scenario(
                        """
                        z, x,y,u,v,w
                        -1,0,0,0.1,1,0
                        -1,5,0,0.2,2,0
                        -9,5,0,0.4,4,0
                        -9,0,0,0.3,3,-0.5
                        """);
        GriddedCurrent current = (GriddedCurrent) loader.load(file).field().getFirst();
        assertThat(current)
                .isEqualTo(
                        new GriddedCurrent(
                                1,
                                "bay",
                                Numbers.of(0, 5),
                                Numbers.of(0),
                                Numbers.of(-9, -1),
                                Numbers.of(0.3, 0.4, 0.1, 0.2),
                                Numbers.of(3, 4, 1, 2),
                                Numbers.of(-0.5, 0, 0, 0)));
        assertThat(current.valueAt(new Vec3(5, 7, -5), 0).y()).isEqualTo(3);
        Validation validation =
                new Validation(MessageCatalogue.load(GridFilesTest.class.getClassLoader()));
        assertThat(validation.faults(file)).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "x,y,z,u,v;0,0,0,1,1|bay.csv:1: expected the columns x, y, z, u, v, w, but there is"
                        + " no column 'w'",
                "x,y,depth,u,v,w;0,0,0,1,1,1|bay.csv:1: expected the columns x, y, z, u, v, w, but"
                        + " column 3, 'depth', is none of them",
                "x,y,z,u,v,w,u;0,0,0,1,1,1,1|bay.csv is not CSV: Header contains"
                        + " duplicate fields: [u]",
                "x,y,z,u,v,w;0,0,0,1,1,1;0,1,0,fast,1,1|bay.csv:3: column 4, 'u': expected a finite"
                        + " number, but found 'fast'",
                "x,y,z,u,v,w;0,0,0,1,1,NaN|bay.csv:2: column 6, 'w': expected a finite number, but"
                        + " found 'NaN'",
                "x,y,z,u,v,w;0,0,0,1,1,1;0,0,-0,1,1,1|bay.csv:3: the point (0.0, 0.0, 0.0) is in"
                        + " line 2 already",
                "x,y,z,u,v,w;0,0,0,1,1,1;1,0,0,1,1,1;0,2,0,1,1,1|bay.csv has a hole: no row has the"
                        + " point (1.0, 2.0, 0.0) of its 2 x 2 x 1 points",
                "x,y,z,u,v,w;0,0,0,1,1,1;1,0,0,1,1,1;1,2,0,1,1,1|bay.csv has a hole: no row has the"
                        + " point (0.0, 2.0, 0.0) of its 2 x 2 x 1 points",
                "x,y,z,u,v,w|bay.csv has no points: expected the header x,y,z,u,v,w and a row for"
                        + " each point"
            })
    void aFileThatIsNoGridIsRefusedWithLineAndColumn(String csv, String problem)
            throws IOException {
        Path file = scenario(csv.replace(';', '\n'));
        assertThatExceptionOfType(DocumentException.class)
                .isThrownBy(() -> loader.load(file))
                .withMessageStartingWith(file + ":3:7: ")
                .withMessageContaining(problem + " at scenario/gridded-current@file");
    }

    @Test
    void aFileThatIsNotThereIsNamed() throws IOException {
        Path file = Files.writeString(folder.resolve("bay.xml"), SCENARIO);
        assertThatExceptionOfType(DocumentException.class)
                .isThrownBy(() -> loader.load(file))
                .withMessageContaining("there is no file " + folder.resolve("bay.csv"));
    }

    @Test
    void aScenarioThatIsNoFileCannotNameOne() {
        assertThatExceptionOfType(AuvsmlException.class)
                .isThrownBy(() -> loader.parse(SCENARIO.getBytes(StandardCharsets.UTF_8)))
                .withMessageContaining("current 'bay' has not read its file bay.csv");
    }

    @Test
    void aFolderIsNoGrid() throws Exception {
        Path file = Files.writeString(folder.resolve("bay.xml"), SCENARIO);
        Files.createDirectory(folder.resolve("bay.csv"));
        assertThatExceptionOfType(DocumentException.class)
                .isThrownBy(() -> loader.load(file))
                .withMessageContaining("bay.csv is a folder; expected a CSV file");
    }
}
