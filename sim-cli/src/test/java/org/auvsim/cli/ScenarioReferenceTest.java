package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.core.description.Default;
import org.auvsim.core.description.Name;
import org.auvsim.core.description.Unit;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.io.InputStream;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** docs/scenarios.md has what the records have, no less and no more. */
class ScenarioReferenceTest {
    private static final Path DOCUMENT = Path.of("..", "docs", "scenarios.md");
    private static final Pattern ROW = Pattern.compile("(\\| `.*) \\| [^|]+ \\|");
    private static final List<Class<?>> OPTIONAL_NUMBERS =
            List.of(OptionalLong.class, OptionalDouble.class, OptionalInt.class);

    /** What stands where vectors and quaternions do is said once, in the text. */
    private static final String MATHEMATICS = "org.auvsim.core.math";

    /** Table rows without their meanings, by element. */
    private final Map<String, List<String>> expected = new LinkedHashMap<>();

    private final Map<String, Class<?>> types = new HashMap<>();

    @Test
    void hasARowForEachComponentOfEachRecord() throws Exception {
        describe("scenario", Scenario.class);

        assertThat(documented()).containsExactlyInAnyOrderEntriesOf(expected);
    }

    private static Map<String, List<String>> documented() throws IOException {
        Map<String, List<String>> rows = new LinkedHashMap<>();
        String element = "";
        for (String line : Files.readAllLines(DOCUMENT, UTF_8)) {
            if (line.startsWith("## `")) {
                element = line.substring(4, line.length() - 1);
            }
            Matcher row = ROW.matcher(line);
            if (row.matches()) {
                rows.computeIfAbsent(element, _ -> new ArrayList<>()).add(row.group(1));
            }
        }
        return rows;
    }

    private void describe(String element, Class<?> type) throws Exception {
        RecordComponent[] components = type.getRecordComponents();
        if (components.length == 0 || expected.containsKey(element)) {
            return;
        }
        types.put(element, type);
        List<String> rows = new ArrayList<>();
        expected.put(element, rows);
        for (RecordComponent component : components) {
            rows.add(row(component));
        }
        for (RecordComponent component : components) {
            describeInner(element, component);
        }
    }

    /**
     * An element that two parents mean differently is headed "`name` of `parent`" in the second.
     */
    private void describeInner(String parent, RecordComponent component) throws Exception {
        Class<?> type = inner(component.getGenericType());
        if (type.isRecord() && !type.getPackageName().equals(MATHEMATICS)) {
            String name = name(component);
            boolean isTaken = !types.getOrDefault(name, type).equals(type);
            describe(isTaken ? name + "` of `" + parent : name, type);
        } else if (type.isInterface()) {
            for (Class<?> implementation : implementations(type)) {
                describe(kebab(implementation.getSimpleName()), implementation);
            }
        }
    }

    private static String row(RecordComponent component) throws Exception {
        Unit unit = component.getAnnotation(Unit.class);
        return "| `%s` | %s | %s | %s"
                .formatted(
                        name(component),
                        form(component),
                        unit == null ? "-" : unit.value(),
                        defaultOf(component));
    }

    private static String defaultOf(RecordComponent component) {
        Default value = component.getAnnotation(Default.class);
        Class<?> type = component.getType();
        boolean mayBeMissing =
                type == Optional.class || type == List.class || OPTIONAL_NUMBERS.contains(type);
        return value != null ? value.value() : mayBeMissing ? "-" : "needed";
    }

    private static String form(RecordComponent component) throws Exception {
        boolean many = component.getType() == List.class;
        Class<?> type = inner(component.getGenericType());
        if (type.isInterface()) {
            List<String> names =
                    implementations(type).stream()
                            .map(implementation -> kebab(implementation.getSimpleName()))
                            .sorted()
                            .map(name -> "`" + name + "`")
                            .toList();
            return (many ? "any of " : "one of ") + String.join(", ", names);
        }
        String one = type.isRecord() ? "element" : "attribute";
        return many ? one + "s" : one;
    }

    /** What a list or an optional holds; else the type itself. */
    private static Class<?> inner(Type type) {
        Type held =
                type instanceof ParameterizedType outer ? outer.getActualTypeArguments()[0] : type;
        return (Class<?>) (held instanceof ParameterizedType generic ? generic.getRawType() : held);
    }

    private static List<Class<?>> implementations(Class<?> type) throws Exception {
        List<Class<?>> found = new ArrayList<>();
        String file = "META-INF/services/" + type.getName();
        ClassLoader loader = ScenarioReferenceTest.class.getClassLoader();
        List<URL> files = Collections.list(loader.getResources(file));
        assertThat(files).as(file).isNotEmpty();
        for (URL one : files) {
            try (InputStream in = one.openStream()) {
                for (String line : new String(in.readAllBytes(), UTF_8).lines().toList()) {
                    String name = line.replaceFirst("#.*", "").strip();
                    if (!name.isEmpty()) {
                        found.add(Class.forName(name));
                    }
                }
            }
        }
        return found;
    }

    private static String name(RecordComponent component) {
        Name name = component.getAnnotation(Name.class);
        return name == null ? kebab(component.getName()) : name.value();
    }

    private static String kebab(String javaName) {
        return javaName.replaceAll("(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "-")
                .toLowerCase(Locale.ROOT);
    }
}
