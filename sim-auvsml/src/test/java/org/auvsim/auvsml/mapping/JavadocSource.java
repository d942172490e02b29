package org.auvsim.auvsml.mapping;

import org.auvsim.core.description.ElementName;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** The comment of a type, read from its source: what documentation says of it is written once. */
record JavadocSource(String description, Map<String, String> parameters) {
    private static final Path SOURCES = Path.of("src", "main", "java");

    /** To another message: all are on one page, under the names of their elements. */
    private static final Pattern LINK = Pattern.compile("\\{@link\\s+(\\w+)}");

    private static final Pattern PARAMETER = Pattern.compile("^(\\w+)\\s+(.*)$", Pattern.DOTALL);

    /** The comment above a top-level type of this module. */
    static JavadocSource of(Class<?> type) throws IOException {
        return read(type.getName(), "\npublic ");
    }

    /** The comment above a package's declaration. */
    static JavadocSource ofPackage(String name) throws IOException {
        return read(name + ".package-info", "\n@NullMarked");
    }

    private static JavadocSource read(String name, String declaration) throws IOException {
        Path file = SOURCES.resolve(name.replace('.', '/') + ".java");
        String source = Files.readString(file);
        int end = source.lastIndexOf("*/", source.indexOf(declaration));
        int begin = source.lastIndexOf("/**", end);
        return parse(source.substring(begin + 3, end));
    }

    private static JavadocSource parse(String comment) {
        String text =
                comment.lines()
                        .map(line -> line.strip().replaceFirst("^\\*\\s?", ""))
                        .collect(Collectors.joining("\n"))
                        .strip();
        String[] parts = text.split("(?m)^@param ", -1);
        Map<String, String> parameters = new LinkedHashMap<>();
        for (int i = 1; i < parts.length; i++) {
            MatchResult parameter =
                    PARAMETER.matcher(parts[i].strip()).results().findFirst().orElseThrow();
            parameters.put(parameter.group(1), markdown(parameter.group(2)));
        }
        return new JavadocSource(markdown(parts[0]), parameters);
    }

    private static String markdown(String javadoc) {
        return LINK.matcher(javadoc.replaceAll("\\{@code ([^}]*)}", "`$1`"))
                .replaceAll(link -> "[%1$s](#%1$s)".formatted(ElementName.of(link.group(1))))
                .replaceAll("\\s+", " ")
                .replaceAll("</?p>", "")
                .strip();
    }
}
