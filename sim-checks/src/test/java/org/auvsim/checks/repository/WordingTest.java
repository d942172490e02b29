package org.auvsim.checks.repository;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

class WordingTest {
    private static final Path FILE = Path.of("notes.md");

    @TempDir private Path root;

    @ParameterizedTest
    @ValueSource(strings = {"/ho#me/alice", "/Us#ers/alice", "/ro#ot/log", "C:\\Us#ers\\alice"})
    void findsAHomeFolder(String path) throws IOException {
        write("one\ntwo " + path.replace("#", ""));
        assertThat(Wording.offences(root, FILE))
                .containsExactly("notes.md:2 names somebody's home folder");
    }

    @Test
    void findsWorkLeftUndone() throws IOException {
        write("one\n\nthree TO" + "DO");
        assertThat(Wording.offences(root, FILE))
                .containsExactly("notes.md:3 names work left undone");
    }

    @Test
    void letsTheRestPass() throws IOException {
        write("~/.jdks, $HOME/x, /usr/lib/jvm, the root/leaf, todo lists of others");
        assertThat(Wording.offences(root, FILE)).isEmpty();
    }

    private void write(String text) throws IOException {
        Files.writeString(root.resolve(FILE), text);
    }
}
