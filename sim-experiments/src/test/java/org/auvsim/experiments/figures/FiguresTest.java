package org.auvsim.experiments.figures;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.stream.Stream;

/** The figures of the documentation are what the simulator draws today. */
class FiguresTest {
    private static final Path IMAGES = Path.of("..", "docs", "images");
    private static final String COMMAND =
            "mvn -q test -pl sim-experiments -am -Dtest=FiguresTest -Dauvsim.generate"
                    + " -Dsurefire.failIfNoSpecifiedTests=false";

    /** With {@code -Dauvsim.generate} they are written instead. */
    @Test
    void theDocumentationOfEffectsShowsWhatTheSimulatorDoes() throws IOException {
        assertDrawn(IMAGES.resolve("effects"), Figures.ofEffects());
    }

    /** Likewise. */
    @Test
    void theDocumentationOfCausesShowsWhatTheyLeaveInResiduals() throws IOException {
        assertDrawn(IMAGES.resolve("causes"), Figures.ofCauses());
    }

    private static void assertDrawn(Path folder, Map<String, String> pictures) throws IOException {
        if (System.getProperty("auvsim.generate") != null) {
            Files.createDirectories(folder);
            for (Map.Entry<String, String> picture : pictures.entrySet()) {
                Files.writeString(folder.resolve(picture.getKey()), picture.getValue());
            }
        }
        try (Stream<Path> files = Files.list(folder)) {
            assertThat(files.map(file -> file.getFileName().toString()))
                    .as("generate them with: %s", COMMAND)
                    .containsExactlyInAnyOrderElementsOf(pictures.keySet());
        }
        for (Map.Entry<String, String> picture : pictures.entrySet()) {
            assertThat(Files.readString(folder.resolve(picture.getKey())))
                    .as("%s; generate it with: %s", picture.getKey(), COMMAND)
                    .isEqualTo(picture.getValue());
        }
    }

    /** Both axes have round numbers, and each line as many points as it should. */
    @Test
    void aFigureHasTicksAndLines() {
        Axis axis = new Axis("x", -0.3, 1.04, 0, 100);
        assertThat(axis.ticks().stream().map(axis::text))
                .containsExactly("-0.2", "0.0", "0.2", "0.4", "0.6", "0.8", "1.0");
        assertThat(axis.place(1.04)).isEqualTo(100);
        assertThat(Series.of("line", 0, 2, x -> x * x).points())
                .hasSize(201)
                .last()
                .isEqualTo(new Series.Point(2, 4));
    }
}
