package org.auvsim.checks.repository;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Finds the relative links of a Markdown file that lead nowhere. */
final class Links {
    private static final Pattern BLOCK = Pattern.compile("(?ms)^ *```.*?^ *```");
    private static final Pattern CODE = Pattern.compile("`[^`\n]*`");
    private static final Pattern LINK =
            Pattern.compile("\\]\\(<?([^)>\\s]+)>?(?:\\s+\"[^\"]*\")?\\)");
    private static final Pattern ELSEWHERE = Pattern.compile("[a-z]+:.*");
    private static final Pattern HEADING = Pattern.compile("(?m)^#+\\s+(.+?)\\s*$");

    private Links() {}

    /** A sentence for each broken link of a file. */
    static List<String> broken(Path root, Path file) throws IOException {
        List<String> broken = new ArrayList<>();
        Matcher links = LINK.matcher(CODE.matcher(prose(root.resolve(file))).replaceAll(""));
        while (links.find()) {
            String link = links.group(1);
            if (!ELSEWHERE.matcher(link).matches() && !leadsSomewhere(root.resolve(file), link)) {
                broken.add(file + " links to " + link + ", which is not there");
            }
        }
        return broken;
    }

    private static boolean leadsSomewhere(Path from, String link) throws IOException {
        String[] parts = link.split("#", 2);
        Path target = parts[0].isEmpty() ? from : from.resolveSibling(parts[0]).normalize();
        if (parts.length == 1 || !target.toString().endsWith(".md")) {
            return Files.exists(target);
        }
        return Files.exists(target) && anchors(prose(target)).contains(parts[1]);
    }

    /** The file's text without its blocks of code. */
    private static String prose(Path file) throws IOException {
        return BLOCK.matcher(Files.readString(file)).replaceAll("");
    }

    /** The headings, written as GitHub writes their anchors. */
    private static List<String> anchors(String prose) {
        return HEADING.matcher(prose)
                .results()
                .map(heading -> heading.group(1).toLowerCase(Locale.ROOT))
                .map(heading -> heading.replaceAll("[^\\p{L}\\p{N}_ -]", "").replace(' ', '-'))
                .toList();
    }
}
