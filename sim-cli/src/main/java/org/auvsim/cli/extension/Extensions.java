package org.auvsim.cli.extension;

import org.auvsim.cli.report.FileTrouble;
import org.auvsim.cli.report.UserError;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.ServiceConfigurationError;
import java.util.concurrent.Callable;
import java.util.stream.Stream;

/**
 * The jars of the extension folders, behind one class loader. It stays open as long as the process:
 * its threads may load from it to the end.
 */
public final class Extensions {
    private final List<ExtensionJar> jars;
    private final ClassLoader loader;

    private Extensions(List<ExtensionJar> jars, ClassLoader loader) {
        this.jars = jars;
        this.loader = loader;
    }

    /**
     * Those of the user's folder, {@code .auvsim/extensions} in {@code home} if it is there, and of
     * a folder that is named.
     *
     * @throws UserError if that folder is not there, or a jar cannot be used
     */
    public static Extensions in(Path home, Optional<Path> named) {
        List<ExtensionJar> jars = new ArrayList<>();
        Path usual = home.resolve(".auvsim").resolve("extensions");
        if (Files.isDirectory(usual)) {
            jars.addAll(jarsIn(usual));
        }
        named.filter(folder -> !isSame(folder, usual))
                .ifPresent(folder -> jars.addAll(jarsIn(requireFolder(folder))));
        ClassLoader own = Extensions.class.getClassLoader();
        if (jars.isEmpty()) {
            return new Extensions(jars, own);
        }
        Extensions extensions =
                new Extensions(List.copyOf(jars), new URLClassLoader(urls(jars), own));
        new ProviderCheck(extensions.loader, own).check(jars);
        return extensions;
    }

    private static Path requireFolder(Path folder) {
        if (!Files.isDirectory(folder)) {
            throw new UserError(
                    "--extensions: %s; name a folder with jars of extensions."
                            .formatted(
                                    Files.exists(folder)
                                            ? folder + " is no folder"
                                            : "there is no folder " + folder));
        }
        return folder;
    }

    private static boolean isSame(Path folder, Path other) {
        try {
            return Files.exists(folder) && Files.exists(other) && Files.isSameFile(folder, other);
        } catch (IOException e) {
            throw FileTrouble.reading(folder, e);
        }
    }

    private static List<ExtensionJar> jarsIn(Path folder) {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.toString().endsWith(".jar"))
                    .sorted()
                    .map(ExtensionJar::read)
                    .toList();
        } catch (IOException e) {
            throw FileTrouble.reading(folder, e);
        }
    }

    private static URL[] urls(List<ExtensionJar> jars) {
        return jars.stream().map(jar -> url(jar.file())).toArray(URL[]::new);
    }

    private static URL url(Path file) {
        try {
            return file.toUri().toURL();
        } catch (MalformedURLException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Does something in whose context, and in that of the threads that it starts, the extensions'
     * providers are found.
     *
     * @throws UserError if an extension needs a class that is in no jar
     */
    public <T> T during(Callable<T> action) throws Exception {
        Thread thread = Thread.currentThread();
        ClassLoader before = thread.getContextClassLoader();
        thread.setContextClassLoader(loader);
        try {
            return action.call();
        } catch (LinkageError | ServiceConfigurationError e) {
            if (jars.isEmpty()) {
                throw e;
            }
            throw new UserError(
                    "An extension does not fit with what is there (%s): put the jars that it needs"
                                    .formatted(e)
                            + " beside %s, or compile it against this version of auvsim."
                                    .formatted(jars.getFirst().file()),
                    e);
        } finally {
            thread.setContextClassLoader(before);
        }
    }
}
