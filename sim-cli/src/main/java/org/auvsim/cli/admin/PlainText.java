package org.auvsim.cli.admin;

import org.auvsim.auvsml.framing.AuvsmlWriter;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.session.CommandDoneResponse;
import org.auvsim.auvsml.message.session.DisconnectedNotification;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.core.description.ElementName;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.stream.Collectors;

/**
 * Messages as text for people: values by name, lists as tables, what can be sent back as AUVSML.
 */
final class PlainText {
    private final AuvsmlWriter writer;

    PlainText(MessageCatalogue catalogue) {
        writer = new AuvsmlWriter(catalogue);
    }

    /** A message in one or more lines. */
    String of(Message message) {
        return switch (message) {
            case CommandDoneResponse _ -> "done";
            case ErrorResponse error -> "refused: " + error.text();
            case DisconnectedNotification end -> "disconnected: " + end.reason();
            default -> hasDescriptions(message.getClass()) ? inside(message) : plain(message);
        };
    }

    /**
     * Whether it holds effects, fields, world objects or the like, which are best seen as they are
     * sent back.
     */
    private static boolean hasDescriptions(Class<?> record) {
        return Arrays.stream(record.getRecordComponents())
                .map(PlainText::elementType)
                .anyMatch(
                        type ->
                                type instanceof Class<?> c
                                        && (c.isInterface()
                                                || (c.isRecord() && hasDescriptions(c))));
    }

    private static Type elementType(RecordComponent component) {
        return component.getGenericType() instanceof ParameterizedType generic
                        && generic.getRawType() == List.class
                ? raw(generic.getActualTypeArguments()[0])
                : component.getType();
    }

    private static Type raw(Type type) {
        return type instanceof ParameterizedType generic ? generic.getRawType() : type;
    }

    private String inside(Message message) {
        return writer.writeIndented(message)
                .lines()
                .filter(line -> !line.matches("</?auvsml>"))
                .map(line -> line.startsWith("  ") ? line.substring(2) : line)
                .collect(Collectors.joining("\n"));
    }

    private static String plain(Message message) {
        List<String> values = new ArrayList<>();
        List<String> tables = new ArrayList<>();
        for (RecordComponent component : message.getClass().getRecordComponents()) {
            Object value = value(component, message);
            if (value instanceof List<?> rows && component.getType() == List.class) {
                tables.add(Table.of(component, rows));
            } else {
                values.add(name(component) + " " + cell(value));
            }
        }
        String head = ElementName.of(message.getClass()).replaceAll("-response$", "");
        String line = head.replace('-', ' ') + (values.isEmpty() ? "" : ": ");
        return tables.isEmpty() ? line + String.join(", ", values) : String.join("\n", tables);
    }

    static String name(RecordComponent component) {
        return ElementName.of(component.getName()).replace('-', ' ');
    }

    static Object value(RecordComponent component, Object record) {
        try {
            return component.getAccessor().invoke(record);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(component + " cannot be read", e);
        }
    }

    /** A value in few words; several of them with blanks between. */
    static String cell(Object value) {
        return switch (value) {
            case Boolean flag -> flag ? "yes" : "no";
            case Optional<?> maybe -> maybe.map(PlainText::cell).orElse("-");
            case OptionalDouble maybe ->
                    maybe.isPresent() ? Double.toString(maybe.getAsDouble()) : "-";
            case OptionalLong maybe -> maybe.isPresent() ? Long.toString(maybe.getAsLong()) : "-";
            case OptionalInt maybe -> maybe.isPresent() ? Integer.toString(maybe.getAsInt()) : "-";
            case List<?> list ->
                    list.isEmpty()
                            ? "-"
                            : list.stream().map(PlainText::cell).collect(Collectors.joining(" "));
            case Record record ->
                    Arrays.stream(record.getClass().getRecordComponents())
                            .map(component -> cell(value(component, record)))
                            .collect(Collectors.joining(" "));
            default -> String.valueOf(value);
        };
    }
}
