package org.auvsim.checks.repository;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.checks.Repository;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The tracked files are as they should be. */
class RepositoryTest {
    private static final Path ROOT = Repository.root();

    @Test
    void noFileSaysWhatNoneMay() throws Exception {
        List<String> offences = new ArrayList<>();
        for (Path file :
                tracked(".java", ".xml", ".md", ".py", ".sh", ".yml", ".csv", ".txt", "run")) {
            offences.addAll(Wording.offences(ROOT, file));
        }
        assertThat(offences).isEmpty();
    }

    @Test
    void everyLinkLeadsSomewhere() throws Exception {
        List<String> broken = new ArrayList<>();
        for (Path file : tracked(".md")) {
            broken.addAll(Links.broken(ROOT, file));
        }
        assertThat(broken).isEmpty();
    }

    /** The one module that stands on a library under the GPL; no other may. */
    @Test
    void whatIsUnderTheGplSaysSo() throws Exception {
        List<Path> files = TrackedFiles.of(ROOT);
        assertThat(files)
                .filteredOn(file -> file.startsWith("sim-osp"))
                .isNotEmpty()
                .allSatisfy(
                        file ->
                                assertThat(Files.readString(ROOT.resolve(file)))
                                        .contains("SPDX-License-Identifier: GPL-2.0-or-later"));
        assertThat(tracked(".java", ".scala"))
                .filteredOn(file -> !file.startsWith("sim-osp"))
                .noneMatch(file -> importsOpenSourcePhysics(ROOT.resolve(file)));
    }

    private static boolean importsOpenSourcePhysics(Path file) {
        try {
            return Files.readString(file).contains("import org.opensource" + "physics");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"auvsim", ".ci/run"})
    void scriptsAreExecutable(String script) {
        assertThat(ROOT.resolve(script)).isExecutable();
    }

    private static List<Path> tracked(String... endings) throws IOException, InterruptedException {
        List<Path> files =
                TrackedFiles.of(ROOT).stream()
                        .filter(
                                file ->
                                        List.of(endings).stream()
                                                .anyMatch(file.toString()::endsWith))
                        .toList();
        assertThat(files).isNotEmpty();
        return files;
    }
}
