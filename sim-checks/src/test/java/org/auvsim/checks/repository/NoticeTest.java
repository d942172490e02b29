package org.auvsim.checks.repository;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.checks.Repository;
import org.junit.jupiter.api.Test;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** NOTICE lists the libraries that are shipped, and no other. */
class NoticeTest {
    private static final Pattern JAR = Pattern.compile("(.+?)-\\d[^/]*\\.jar");
    private static final Pattern OURS = Pattern.compile("auvsim|sim-.*|examples");
    private static final Pattern OF_TESTS =
            Pattern.compile("junit-.*|opentest4j|apiguardian-api|assertj-.*|byte-buddy|archunit");
    private static final Pattern LISTED = Pattern.compile("(?m)^([a-z][a-z0-9.-]*)  .*https://");

    @Test
    void listsWhatIsShipped() throws IOException {
        assertThat(listed()).isEqualTo(shipped());
    }

    private static Set<String> listed() throws IOException {
        return LISTED.matcher(Files.readString(Repository.root().resolve("NOTICE")))
                .results()
                .map(line -> line.group(1))
                .collect(Collectors.toCollection(TreeSet::new));
    }

    /** The jars of this test's class path, which has sim-cli's and the tests' own. */
    private static Set<String> shipped() {
        return Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator, -1))
                .map(entry -> JAR.matcher(Path.of(entry).getFileName().toString()))
                .filter(jar -> jar.matches())
                .map(jar -> jar.group(1))
                .filter(name -> !OURS.matcher(name).matches())
                .filter(name -> !OF_TESTS.matcher(name).matches())
                .collect(Collectors.toCollection(TreeSet::new));
    }
}
