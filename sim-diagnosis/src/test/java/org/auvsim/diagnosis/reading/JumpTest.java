package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.run.ColumnMapping;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Path;
import java.util.Random;
import java.util.function.IntToDoubleFunction;

/** A run that goes on elsewhere is told to, with the row from which on. */
class JumpTest {
    private static final int ROWS = 200;

    @TempDir private Path folder;

    private RunFile read(IntToDoubleFunction y) throws Exception {
        String text =
                Rov.rows(
                        "x,y,main,rudder", ROWS, i -> 0.01 * i + "," + y.applyAsDouble(i) + ",0,0");
        return Rov.read(folder, ColumnMapping.USUAL, text);
    }

    private static double way(int row, Random noise) {
        return 3 * Math.sin(0.05 * row) + 0.05 * noise.nextGaussian();
    }

    @Test
    void anotherRunThatFollowsIsTold() throws Exception {
        Random noise = new Random(1);
        RunFile file = read(i -> way(i, noise) + (i < 150 ? 0 : 12));

        assertThat(file.notices())
                .filteredOn(notice -> notice.contains("does another run begin here"))
                .singleElement()
                .asString()
                .startsWith(
                        folder.resolve("run.csv")
                                + ":152: column 'y': at 15 s the body is 12 m from where it was"
                                + " before, ");
        assertThat(file.doubt()).isEqualTo(Doubt.LASTING);
    }

    @Test
    void aWayWithNoiseAndTurnsIsNoJump() throws Exception {
        Random noise = new Random(1);
        isNoJump(read(i -> way(i, noise)));
    }

    /** Far away for a row, which is told as that. */
    @Test
    void oneWrongNumberIsNoJump() throws Exception {
        Random noise = new Random(1);
        isNoJump(read(i -> way(i, noise) + (i == 150 ? 12 : 0)));
    }

    /** At rest, and then thrown. */
    @Test
    void aBodyThatBeginsToMoveDoesNotJump() throws Exception {
        Random noise = new Random(1);
        isNoJump(read(i -> 0.001 * noise.nextGaussian() + (i < 50 ? 0 : 0.4 * (i - 50))));
    }

    private static void isNoJump(RunFile file) {
        assertThat(file.notices()).noneMatch(notice -> notice.contains("another run begin"));
    }
}
