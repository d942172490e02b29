package org.auvsim.auvsml.document;

import org.auvsim.auvsml.mapping.Names;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** What is said of a file that there is not, and of one that may have been meant. */
public final class MissingFile {
    private static final int MOST_TOLD = 3;

    private MissingFile() {}

    /** The sentence. */
    public static String sentence(Path file) {
        return sentence(file, List.of());
    }

    /**
     * The sentence. Meant may have been a file whose name differs by capitals, one of the same name
     * in another folder, one whose name ends otherwise, or one whose name differs by a slip.
     *
     * @param folders others in which it may be
     */
    public static String sentence(Path file, List<Path> folders) {
        return file
                + ": there is no such file"
                + hint(capitals(file))
                        .or(() -> hint(elsewhere(file, folders)))
                        .or(() -> hint(beside(file, other -> stem(other).equals(stem(file)))))
                        .or(() -> hint(beside(file, other -> isSlip(file, other))))
                        .or(() -> folder(file))
                        .orElse("");
    }

    /** Files whose names are the same but for capitals. */
    public static List<Path> capitals(Path file) {
        String name = file.getFileName().toString();
        return beside(file, other -> other.getFileName().toString().equalsIgnoreCase(name));
    }

    private static List<Path> beside(Path file, Predicate<Path> isAlike) {
        Path folder = file.toAbsolutePath().getParent();
        if (folder == null || !Files.isDirectory(folder)) {
            return List.of();
        }
        try (Stream<Path> others = Files.list(folder)) {
            return others.filter(Files::isRegularFile)
                    .filter(isAlike)
                    .map(other -> file.resolveSibling(other.getFileName()))
                    .filter(other -> !other.equals(file))
                    .sorted()
                    .toList();
        } catch (IOException _) {
            return List.of();
        }
    }

    private static List<Path> elsewhere(Path file, List<Path> folders) {
        return folders.stream()
                .flatMap(
                        folder ->
                                Stream.of(folder.resolve(file), folder.resolve(file.getFileName())))
                .filter(Files::isRegularFile)
                .distinct()
                .toList();
    }

    /** A file's name in small letters, without its ending. */
    private static String stem(Path file) {
        return file.getFileName()
                .toString()
                .toLowerCase(Locale.ROOT)
                .replaceFirst("(?<=.)([.]auvsml)?[.][^.]*$", "");
    }

    /** Whether a letter is another: names that count by numbers are all alike but for these. */
    private static boolean isSlip(Path file, Path other) {
        String name = file.getFileName().toString();
        String known = other.getFileName().toString();
        return numbers(name).equals(numbers(known)) && !Names.near(name, List.of(known)).isEmpty();
    }

    private static String numbers(String name) {
        return name.replaceAll("[^0-9]", "");
    }

    private static Optional<String> hint(List<Path> others) {
        return others.isEmpty()
                ? Optional.empty()
                : Optional.of(
                        others.stream()
                                .limit(MOST_TOLD)
                                .map(Path::toString)
                                .collect(Collectors.joining(" or ", "; did you mean ", "?")));
    }

    private static Optional<String> folder(Path file) {
        return Optional.ofNullable(file.getParent())
                .filter(Files::notExists)
                .map("; there is no folder %s either"::formatted);
    }
}
