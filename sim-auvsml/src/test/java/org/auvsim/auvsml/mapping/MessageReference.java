package org.auvsim.auvsml.mapping;

import org.auvsim.auvsml.framing.AuvsmlWriter;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.Command;
import org.auvsim.auvsml.message.command.EventType;
import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.core.description.ElementName;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/** docs/auvsml.md: every message with its parts and an example, from records and their comments. */
final class MessageReference {
    private final MessageCatalogue catalogue;
    private final Map<Class<?>, Message> examples;
    private final StringBuilder out = new StringBuilder();

    private MessageReference(MessageCatalogue catalogue, Map<Class<?>, Message> examples) {
        this.catalogue = catalogue;
        this.examples = examples;
    }

    static String write(MessageCatalogue catalogue, Map<Class<?>, Message> examples)
            throws IOException {
        MessageReference reference = new MessageReference(catalogue, examples);
        reference.document();
        return reference.out.toString();
    }

    private void document() throws IOException {
        out.append(
                """
                # AUVSML

                Generated from the messages' records; the same as a schema: [auvsml.xsd](auvsml.xsd).

                - A message stands in a root element `<auvsml>`; several may stand in one. `<auvxml>`, as the
                  thesis' appendix prints the root, is read too. Roots follow one another on the
                  connection; white space, comments and XML declarations between them are fine.
                - An element is named after its record (`PauseSimulatorCommand`:
                  `pause-simulator-command`), what stands inside after the record's components. Single
                  values are attributes; attributes and elements may come in any order. Booleans are `1`
                  and `0`; numbers are decimal, never NaN or infinite. UTF-8 only; no DOCTYPE, no entities.
                - `request-id` on a root comes back on the root of its response or error; with it, a
                  command without a response of its own is answered by `command-done-response`.
                - What is wrong is answered by `error-response` with line and column counted from the
                  connection's first byte; nothing of that root is done, and the next root is read.
                - A root may have 64 KiB, 32 levels and 64 attributes an element.
                """);
        out.append("- Event types to listen to: ");
        out.append(String.join(", ", EventType.names().stream().map(n -> "`" + n + "`").toList()));
        out.append(".\n");
        contents();
        for (String name : packages()) {
            out.append("\n## ").append(title(name)).append("\n\n");
            out.append(JavadocSource.ofPackage(name).description()).append('\n');
            for (Class<?> type : typesIn(name)) {
                message(type);
            }
        }
    }

    private Set<String> packages() {
        Set<String> names = new LinkedHashSet<>();
        List.of(
                        "listening",
                        "movement",
                        "sensing",
                        "radio",
                        "feedback",
                        "control",
                        "entity",
                        "session")
                .forEach(name -> names.add(Message.class.getPackageName() + "." + name));
        catalogue.types().forEach(type -> names.add(type.getPackageName()));
        return names;
    }

    private List<Class<?>> typesIn(String packageName) {
        return catalogue.types().stream()
                .filter(type -> type.getPackageName().equals(packageName))
                .toList();
    }

    private static String title(String packageName) {
        String name = packageName.substring(packageName.lastIndexOf('.') + 1);
        return name.substring(0, 1).toUpperCase(Locale.ROOT) + name.substring(1);
    }

    private void contents() {
        out.append("\n| message | sent by |\n|---|---|\n");
        for (String name : packages()) {
            for (Class<?> type : typesIn(name)) {
                String element = ElementName.of(type);
                out.append("| [%s](#%s) | %s |\n".formatted(element, element, sender(type)));
            }
        }
    }

    private static String sender(Class<?> type) {
        return Command.class.isAssignableFrom(type) || FeedbackMessage.class.isAssignableFrom(type)
                ? "client"
                : "server";
    }

    private void message(Class<?> type) throws IOException {
        JavadocSource comment = JavadocSource.of(type);
        out.append("\n### ").append(ElementName.of(type)).append("\n\n");
        out.append(comment.description()).append("\n\n");
        parts(type, comment);
        Message example = examples.get(type);
        if (example == null) {
            throw new AssertionError("no example of " + type + "; add one to examples.xml");
        }
        out.append("```xml\n");
        out.append(new AuvsmlWriter(catalogue).writeIndented(example)).append("\n```\n");
    }

    private void parts(Class<?> type, JavadocSource comment) {
        List<Slot> slots = catalogue.mapper().codec(type).slots();
        if (slots.isEmpty()) {
            return;
        }
        out.append("| part | what | |\n|---|---|---|\n");
        for (Slot slot : slots) {
            String component = type.getRecordComponents()[slot.index()].getName();
            out.append(
                    "| %s | %s | %s |\n"
                            .formatted(
                                    part(slot),
                                    what(slot),
                                    comment.parameters().getOrDefault(component, "")));
        }
        out.append('\n');
    }

    private static String part(Slot slot) {
        return slot.content() instanceof Slot.Attribute
                ? "`" + slot.name() + "`"
                : "`<" + slot.name() + ">`";
    }

    private static String what(Slot slot) {
        List<String> words = new ArrayList<>();
        switch (slot.content()) {
            case Slot.Attribute(ScalarCodec codec) -> words.add(codec.expected());
            case Slot.Elements(Class<?> type) -> words.add(componentsOf(type));
            case Slot.Choice(_, Map<String, Class<?>> byName) ->
                    words.add("one of " + String.join(", ", byName.keySet()));
        }
        slot.unit().ifPresent(words::add);
        if (slot.isMany()) {
            words.add("any number");
        } else if (slot.presence() instanceof Presence.Defaulted(Object value)) {
            words.add("else " + value);
        } else if (!slot.isRequired()) {
            words.add("may be left out");
        }
        return String.join("; ", words);
    }

    private static String componentsOf(Class<?> type) {
        List<String> names = new ArrayList<>();
        for (var component : type.getRecordComponents()) {
            names.add(ElementName.of(component.getName()));
        }
        return names.size() > 9 ? "as in a scenario" : String.join(", ", names);
    }
}
