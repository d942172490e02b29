package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.run.ColumnMapping;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Path;

/**
 * Runs that cannot be used: each sentence has the file, the row as an editor counts it, and the
 * column.
 */
abstract class RefusedRuns {
    static final int ENOUGH = 20;
    static final String MENDING = "; correct it, or leave the cell empty if nothing was measured";

    @TempDir Path folder;

    void refused(String text, String sentence) {
        refused(ColumnMapping.USUAL, text, sentence);
    }

    void refused(ColumnMapping mapping, String text, String sentence) {
        assertThatThrownBy(() -> Rov.read(folder, mapping, text))
                .isInstanceOf(DocumentException.class)
                .hasMessage(folder.resolve("run.csv") + sentence);
    }

    static String moving(String header, String cells) {
        return Rov.rows("x," + header, ENOUGH, i -> i + "," + cells);
    }
}
