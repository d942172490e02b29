package org.auvsim.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.auvsim.junit.TrajectoryAssert.assertThatTrajectory;

import static java.util.Objects.requireNonNull;

import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

import javax.imageio.ImageIO;

/** Against what uniform motion and an elastic bounce at 4 s give with pencil and paper. */
class TrajectoryAssertTest {
    private static final int RED = 0xD1495B;

    @TempDir private Path folder;

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "box | 'AUV' leaves the box at 3.55 s: x = 3.55 m, allowed -1 to 3.52 m",
                "ball | 'AUV' gets away from (0, 0, -2) at 2.55 s: 2.55 m away, allowed at most"
                        + " 2.52 m",
                "escort | 'AUV' gets away from 'Escort' at 5.15 s: 3.04795 m from origin to origin,"
                        + " allowed at most 3 m",
                "clear | 'Rock' is too near to 'AUV' at 4 s: 1 m from origin to origin,"
                        + " allowed 1.2 m or more",
                "pass | 'AUV' misses (2, 1, -2) and is nearest at 2 s: 1 m away, allowed 0.5 m",
                "end | 'AUV' ends in the wrong place at 6 s: (2, 0, -2), 2 m from (0, 0, -2),"
                        + " allowed 0.5 m",
                "speed | 'Escort' is too fast at 0 s: 1 m/s, allowed 0.9 m/s",
                "meeting | 'AUV' never collides with 'Buoy' and is nearest at 2 s: 3 m from origin"
                        + " to origin, expected a collision; it collides with 'Rock'",
                "nothing | 'AUV' collides with 'Rock' at 4 s: at (4.5, 0, -2) with an impulse of"
                        + " 4 N s, expected no collision",
            },
            quoteCharacter = '"')
    void saysWhenWhatWasFoundAndWhatWasExpected(String test, String sentence) throws IOException {
        Tested tested = Tested.method(WrongExpectations.class, test, folder);

        assertThat(tested.failure()).isInstanceOf(AssertionError.class);
        List<String> lines = requireNonNull(tested.failure().getMessage()).lines().toList();
        assertThat(lines.get(0)).isEqualTo(sentence);
        assertThat(tested.filesPublished()).isEqualTo(1);
        Path picture = onlyFile();
        assertThat(lines.get(1)).isEqualTo("picture: " + picture);
        assertThat(pixels(ImageIO.read(picture.toFile()), RED)).isPositive();
    }

    private Path onlyFile() throws IOException {
        try (var files = Files.list(folder)) {
            List<Path> all = files.toList();
            assertThat(all).hasSize(1);
            return all.getFirst();
        }
    }

    private static int pixels(BufferedImage image, int color) {
        int count = 0;
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                count += (image.getRGB(x, y) & 0xFFFFFF) == color ? 1 : 0;
            }
        }
        return count;
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "recording | a scenario has no movements to match",
                "name | drift.xml has no body 'Submarine'; it has 'AUV' (id 1), 'Escort' (id 2),",
                "tolerance | a tolerance must be 0 m or more and finite, but is -1.0 m",
            },
            quoteCharacter = '"')
    void whatCannotBeAskedIsSaid(String test, String sentence) {
        assertThat(Tested.method(WrongExpectations.class, test, folder).failure())
                .isNotInstanceOf(AssertionError.class)
                .hasMessageStartingWith(sentence);
    }

    @Test
    @ReplayScenario(value = "drift.xml", until = 6)
    void whatHoldsPasses(Replay replay) {
        Trajectory escort = replay.trajectory("Escort");
        assertThatTrajectory(replay.trajectory("AUV"))
                .staysWithin(Region.box(new Vec3(-0.1, -0.1, -2.1), new Vec3(4.1, 0.1, -1.9)))
                .staysWithin(4.1, new Vec3(0, 0, -2))
                .staysWithin(4.5, escort)
                .staysClearOf(escort, 1.9)
                .staysSlowerThan(1.001)
                .passesNear(new Vec3(3, 0, -2), 0.05)
                .collidesWith("Rock")
                .endsNear(new Vec3(2, 0, -2), 1e-6);
        assertThatTrajectory(escort).collidesWithNothing();
    }

    /** JUnit's launchers that keep no files refuse them. */
    @Test
    void withoutAPlaceForThePictureTheFindingIsToldAllTheSame() throws IOException {
        Path noFolder = Files.writeString(folder.resolve("file"), "");

        assertThat(Tested.method(WrongExpectations.class, "nothing", noFolder).failure())
                .isInstanceOf(AssertionError.class)
                .hasMessageStartingWith("'AUV' collides with 'Rock' at 4 s")
                .hasMessageContaining("no picture could be made: ");
    }
}
