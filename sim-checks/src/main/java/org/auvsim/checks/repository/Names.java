package org.auvsim.checks.repository;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Finds the names in a page of documentation that name nothing in the repository. */
final class Names {
    private static final Pattern BLOCK = Pattern.compile("(?ms)^ *```.*?^ *```");
    private static final Pattern QUOTED = Pattern.compile("`([^`\n]+)`");
    private static final Pattern TYPE = Pattern.compile("[A-Z][a-z][A-Za-z0-9]*");
    private static final Pattern MEMBER = Pattern.compile("([A-Z][a-z][A-Za-z0-9]*)\\.([a-z]\\w*)");
    private static final Pattern ELEMENT = Pattern.compile("[a-z]+(-[a-z]+)+");
    private static final Pattern COMMAND = Pattern.compile("auvsim ([a-z]+)");
    private static final Pattern FILE = Pattern.compile("[\\w./-]+\\.(xml|py|md|sh|xsd)");

    private final Map<String, Path> filesByName = new HashMap<>();
    private final Map<String, String> sources = new HashMap<>();

    /** Over these files, relative to the root. */
    Names(Path root, Collection<Path> files) {
        for (Path file : files) {
            filesByName.put(file.getFileName().toString(), root.resolve(file));
            filesByName.put(file.toString(), root.resolve(file));
        }
    }

    /** A sentence for each quoted name in a page that is not there. */
    List<String> unknown(Path page) throws IOException {
        List<String> unknown = new ArrayList<>();
        Matcher quoted = QUOTED.matcher(BLOCK.matcher(Files.readString(page)).replaceAll(""));
        while (quoted.find()) {
            if (!isKnown(quoted.group(1))) {
                unknown.add(
                        page.getFileName()
                                + " names `"
                                + quoted.group(1)
                                + "`, which is not there");
            }
        }
        return unknown;
    }

    private boolean isKnown(String name) {
        Matcher member = MEMBER.matcher(name);
        if (member.matches()) {
            return source(member.group(1))
                    .filter(text -> text.contains(" " + member.group(2) + "("))
                    .isPresent();
        }
        if (TYPE.matcher(name).matches()) {
            return source(name).isPresent();
        }
        if (FILE.matcher(name).matches()) {
            return filesByName.containsKey(name);
        }
        if (ELEMENT.matcher(name).matches()) {
            return source(pascal(name)).isPresent();
        }
        Matcher command = COMMAND.matcher(name);
        if (command.matches()) {
            return isSubcommand(command.group(1));
        }
        return isWordOfSources(name);
    }

    private boolean isSubcommand(String name) {
        String type = Character.toUpperCase(name.charAt(0)) + name.substring(1);
        return source("Auvsim").filter(text -> text.contains(" " + type + ".class")).isPresent();
    }

    private Optional<String> source(String type) {
        return Optional.ofNullable(filesByName.get(type + ".java")).map(this::text);
    }

    /** Whether anything in the Java sources is called so: an enum's constant, an attribute. */
    private boolean isWordOfSources(String name) {
        Pattern word = Pattern.compile("\\b" + Pattern.quote(name) + "\\b");
        return filesByName.values().stream()
                .filter(file -> file.toString().endsWith(".java"))
                .filter(file -> file.toString().contains("/src/main/"))
                .anyMatch(file -> word.matcher(text(file)).find());
    }

    private String text(Path file) {
        return sources.computeIfAbsent(
                file.toString(),
                path -> {
                    try {
                        return Files.readString(file);
                    } catch (IOException e) {
                        throw new UncheckedIOException(e);
                    }
                });
    }

    /** {@code pause-simulator-command} is written by the record PauseSimulatorCommand. */
    private static String pascal(String element) {
        StringBuilder type = new StringBuilder();
        for (String word : element.split("-", -1)) {
            type.append(Character.toUpperCase(word.charAt(0))).append(word.substring(1));
        }
        return type.toString();
    }
}
