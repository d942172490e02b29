package org.auvsim.checks.repository;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

class LinksTest {
    private static final Path FILE = Path.of("docs/a.md");

    @TempDir private Path root;

    @BeforeEach
    void write() throws IOException {
        Files.createDirectory(root.resolve("docs"));
        Files.writeString(root.resolve("docs/b.md"), "# Two, and `code`: here\n");
        Files.createFile(root.resolve("README.md"));
    }

    @Test
    void findsLinksToNowhere() throws IOException {
        Files.writeString(
                root.resolve(FILE),
                "[x](gone.md) ![y](../gone.png \"title\")\n[z](b.md#gone)[w](#gone)");
        assertThat(Links.broken(root, FILE))
                .containsExactly(
                        "docs/a.md links to gone.md, which is not there",
                        "docs/a.md links to ../gone.png, which is not there",
                        "docs/a.md links to b.md#gone, which is not there",
                        "docs/a.md links to #gone, which is not there");
    }

    @Test
    void letsTheRestPass() throws IOException {
        Files.writeString(
                root.resolve(FILE),
                """
                # Here
                [x](b.md) [y](../README.md) [z](b.md#two-and-code-here) [h](#here)
                [web](https://example.org/gone) `[code](gone.md)`
                ```
                [block](gone.md)
                ```
                """);
        assertThat(Links.broken(root, FILE)).isEmpty();
    }
}
