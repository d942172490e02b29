package org.auvsim.cli.extension;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.cli.report.FileTrouble;
import org.auvsim.cli.report.UserError;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.zip.ZipException;

/**
 * A jar of extensions.
 *
 * @param providers what its files {@code META-INF/services/org.auvsim...} name, in their order
 */
record ExtensionJar(Path file, List<Named> providers) {
    private static final String FOLDER = "META-INF/services/";

    /** A class that a provider file names, and the interface that it is to implement. */
    record Named(String type, String provider) {}

    /**
     * Reads what a jar provides.
     *
     * @throws UserError if it cannot be read
     */
    static ExtensionJar read(Path file) {
        try (JarFile jar = new JarFile(file.toFile())) {
            List<Named> providers = new ArrayList<>();
            for (JarEntry entry : jar.stream().filter(ExtensionJar::isOurs).toList()) {
                providers.addAll(providers(jar, entry));
            }
            return new ExtensionJar(file, providers);
        } catch (ZipException e) {
            throw new UserError(
                    "%s is no jar, or a damaged one (%s): copy or build it again, or take it out of the folder."
                            .formatted(file, e.getMessage()),
                    e);
        } catch (IOException e) {
            throw FileTrouble.reading(file, e);
        }
    }

    /** Libraries that an extension needs have provider files of their own, which do not matter. */
    private static boolean isOurs(JarEntry entry) {
        return entry.getName().startsWith(FOLDER + "org.auvsim.");
    }

    private static List<Named> providers(JarFile jar, JarEntry entry) throws IOException {
        String type = entry.getName().substring(FOLDER.length());
        try (BufferedReader lines =
                new BufferedReader(new InputStreamReader(jar.getInputStream(entry), UTF_8))) {
            return lines.lines()
                    .map(line -> line.replaceFirst("#.*", "").strip())
                    .filter(line -> !line.isEmpty())
                    .map(provider -> new Named(type, provider))
                    .toList();
        }
    }
}
