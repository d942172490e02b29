package org.auvsim.auvsml.document;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

class MissingFileTest {
    @TempDir private Path folder;

    private Path there(String name) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        return Files.writeString(file, "t\n");
    }

    private String hint(String missing, Path... folders) {
        Path file = folder.resolve(missing);
        String sentence = MissingFile.sentence(file, List.of(folders));
        assertThat(sentence).startsWith(file + ": there is no such file");
        return sentence.substring((file + ": there is no such file").length());
    }

    @Test
    void nothingIsSaidWhereNothingIsAlike() throws IOException {
        there("run1.csv");
        assertThat(hint("run2.csv")).isEmpty();
    }

    /** Where capitals make no other file, none is missing. */
    @Test
    void capitalsMayDiffer() throws IOException {
        Path file = there("run1.csv");
        there("run1.xml");
        assertThat(hint("Run1.CSV")).isEqualTo("; did you mean " + file + "?");
    }

    @Test
    void theEndingMayBeAnother() throws IOException {
        Path table = there("run1.csv");
        Path recording = there("run2.auvsml.gz");
        there("run1.old/run1.csv");
        assertThat(hint("run1")).isEqualTo("; did you mean " + table + "?");
        assertThat(hint("run1.txt")).isEqualTo("; did you mean " + table + "?");
        assertThat(hint("run2.csv")).isEqualTo("; did you mean " + recording + "?");
    }

    @Test
    void aLetterMayBeAnother() throws IOException {
        Path file = there("run2.csv");
        there("run3.csv");
        assertThat(hint("runn2.csv")).isEqualTo("; did you mean " + file + "?");
        assertThat(hint("rum2.csv")).isEqualTo("; did you mean " + file + "?");
    }

    @Test
    void itMayBeInAnotherFolder() throws IOException {
        Path file = there("model/run1.csv");
        there("run1.xml");
        assertThat(hint("run1.csv", folder.resolve("model")))
                .isEqualTo("; did you mean " + file + "?");
    }

    @Test
    void severalAreTold() throws IOException {
        Path one = there("run1.csv");
        Path other = there("run1.txt");
        assertThat(hint("run1")).isEqualTo("; did you mean " + one + " or " + other + "?");
    }

    @Test
    void aFolderThatIsMissingIsTold() {
        assertThat(hint("none/run1.csv"))
                .isEqualTo("; there is no folder " + folder.resolve("none") + " either");
    }
}
