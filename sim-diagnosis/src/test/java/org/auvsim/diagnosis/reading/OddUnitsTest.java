package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.run.ColumnMapping;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;

/** One run of several in another unit. */
class OddUnitsTest {
    private static final int ROWS = 200;

    @TempDir private Path folder;

    /** A noisy run, its lengths and angles told so many times as large. */
    private Path run(int seed, double lengths, double angles) throws Exception {
        Random random = new Random(seed);
        String text =
                Rov.rows(
                        "x,y,roll,yaw,main,rudder",
                        ROWS,
                        i ->
                                String.format(
                                        Locale.ROOT,
                                        "%.6f,%.6f,%.6f,%.6f,0.5,0",
                                        lengths * (0.1 * i + 0.02 * random.nextGaussian()),
                                        lengths
                                                * (2 * Math.sin(0.03 * i + seed)
                                                        + 0.02 * random.nextGaussian()),
                                        angles * 0.02 * random.nextGaussian(),
                                        angles
                                                * (0.8 * Math.sin(0.05 * i + seed)
                                                        + 0.02 * random.nextGaussian())));
        return Rov.write(folder.resolve("run%d.csv".formatted(seed)), text);
    }

    private static RunFiles read(List<Path> files) throws Exception {
        return RunFiles.read(
                Rov.reader(ColumnMapping.USUAL),
                files.subList(0, files.size() - 1),
                files.subList(files.size() - 1, files.size()));
    }

    private List<Path> sound(int count) throws Exception {
        List<Path> files = new ArrayList<>();
        for (int seed = 1; seed <= count; seed++) {
            files.add(run(seed, 1, 1));
        }
        return files;
    }

    @Test
    void millimetresAreRefused() throws Exception {
        List<Path> files = sound(2);
        files.add(run(3, 1000, 1));

        assertThatThrownBy(() -> read(files))
                .isInstanceOf(DocumentException.class)
                .hasMessage(
                        folder.resolve("run3.csv")
                                + ":2: columns 'x', 'y': 1000 times those of the other files, noise"
                                + " and all: are they in mm, or the others in km? If so, name the"
                                + " columns for their unit (x_mm); if they are right, diagnose this"
                                + " run by itself");
    }

    @Test
    void degreesAreRefused() throws Exception {
        List<Path> files = new ArrayList<>(List.of(run(3, 1, 180 / Math.PI)));
        files.addAll(sound(2));

        assertThatThrownBy(() -> read(files))
                .isInstanceOf(DocumentException.class)
                .hasMessageStartingWith(
                        folder.resolve("run3.csv")
                                + ":2: columns 'roll', 'yaw': angles of several turns, with far"
                                + " more noise than those of the other files: are they in"
                                + " degrees?");
    }

    /** As another vehicle or a worse sensor has it. */
    @Test
    void whatIsTenTimesAsLargeIsRead() throws Exception {
        List<Path> files = sound(2);
        files.add(run(3, 10, 1));
        files.add(run(4, 1, 3));

        assertThat(read(files).fit()).hasSize(3);
    }

    @Test
    void ofTwoNobodyKnowsWhichIsOdd() throws Exception {
        assertThat(read(List.of(run(1, 1, 1), run(2, 1000, 1))).fit()).hasSize(1);
    }
}
