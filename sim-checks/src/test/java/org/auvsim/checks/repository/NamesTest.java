package org.auvsim.checks.repository;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.checks.Repository;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Files;
import java.nio.file.Path;

class NamesTest {
    private static final Path ROOT = Repository.root();

    @Test
    void everyNameOnTheThesisPageExists() throws Exception {
        Names names = new Names(ROOT, TrackedFiles.of(ROOT));

        assertThat(names.unknown(ROOT.resolve("docs/thesis.md"))).isEmpty();
    }

    @Test
    void namesThatAreNotThereAreFound(@TempDir Path folder) throws Exception {
        Path page = folder.resolve("page.md");
        Files.writeString(
                page,
                "`World` `World.fly` `Worldly` `pause-simulator-command` `pause-command` `no.xml`"
                        + " `PROJECTED` `PROJECTOR` `auvsim run` `auvsim fly`");

        assertThat(new Names(ROOT, TrackedFiles.of(ROOT)).unknown(page))
                .map(sentence -> sentence.split("`", -1)[1])
                .containsExactly(
                        "World.fly",
                        "Worldly",
                        "pause-command",
                        "no.xml",
                        "PROJECTOR",
                        "auvsim fly");
    }
}
