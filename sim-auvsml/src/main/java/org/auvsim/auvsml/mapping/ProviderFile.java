package org.auvsim.auvsml.mapping;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.ServiceConfigurationError;
import java.util.Set;

/**
 * {@code META-INF/services/<interface>}, in the format of {@link java.util.ServiceLoader}: class
 * names, a line each, and comments after '#'. Unlike that one, it only looks the classes up, since
 * records have no constructor without arguments.
 */
final class ProviderFile {
    private ProviderFile() {}

    /**
     * The record types that all such files of a class path name, in the files' order.
     *
     * @throws ServiceConfigurationError if a line names no record that implements the interface
     */
    static List<Class<?>> read(Class<?> type, ClassLoader loader) {
        Set<Class<?>> classes = new LinkedHashSet<>();
        try {
            for (URL file : urls(type, loader)) {
                for (String line : lines(file)) {
                    classes.add(recordClass(line, type, loader, file));
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException("the provider files of " + type.getName(), e);
        }
        return List.copyOf(classes);
    }

    private static List<URL> urls(Class<?> type, ClassLoader loader) throws IOException {
        return Collections.list(loader.getResources("META-INF/services/" + type.getName()));
    }

    private static List<String> lines(URL file) throws IOException {
        try (BufferedReader reader =
                new BufferedReader(
                        new InputStreamReader(file.openStream(), StandardCharsets.UTF_8))) {
            List<String> lines = new ArrayList<>();
            reader.lines()
                    .map(line -> line.replaceFirst("#.*", "").strip())
                    .filter(line -> !line.isEmpty())
                    .forEach(lines::add);
            return lines;
        }
    }

    private static Class<?> recordClass(String name, Class<?> type, ClassLoader loader, URL file) {
        try {
            Class<?> found = Class.forName(name, false, loader);
            if (!found.isRecord() || !type.isAssignableFrom(found)) {
                throw new ServiceConfigurationError(
                        "%s names %s, which is not a record that implements %s"
                                .formatted(file, name, type.getName()));
            }
            return found;
        } catch (ClassNotFoundException e) {
            throw new ServiceConfigurationError(
                    file + " names " + name + ", which is not on the class path", e);
        }
    }
}
