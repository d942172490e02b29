package org.auvsim.cli.admin;

import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.mapping.Part;
import org.auvsim.core.description.ElementName;

import java.util.List;
import java.util.Locale;

/**
 * How a command is said in plain words: {@code add-effect-command} as "add effect 1
 * &lt;gravity/&gt;".
 *
 * @param text the words, one blank between two
 * @param element the message's element
 * @param parts of the message
 */
record Phrase(String text, String element, List<Part> parts) {
    static Phrase of(MessageCatalogue catalogue, Class<?> type) {
        String element = ElementName.of(type);
        return new Phrase(words(element), element, catalogue.parts(type));
    }

    /** Without what every command has: "get-effect-list-request" to "list effects". */
    private static String words(String element) {
        String name =
                element.replaceAll("-(command|request|message)$", "").replace("-simulator", "");
        if (name.startsWith("get-") && name.endsWith("-list")) {
            name =
                    "list-"
                            + name.substring("get-".length(), name.length() - "-list".length())
                            + "s";
        }
        return name.replaceAll("^get-", "").replace('-', ' ');
    }

    /** The parts that are attributes, which values without a name are for, in this order. */
    List<Part> attributes() {
        return parts.stream().filter(Part::isAttribute).toList();
    }

    /** The words and what may follow: "set rate RATE". */
    String usage() {
        StringBuilder usage = new StringBuilder(text);
        for (Part part : parts) {
            String name = part.isAttribute() ? place(part.name()) : "<" + part.name() + ">";
            usage.append(' ').append(part.isRequired() ? name : "[" + name + "]");
        }
        return usage.toString();
    }

    private static String place(String attribute) {
        return switch (attribute) {
            case "world-object-id", "agent-id" -> "OBJECT";
            case "entity-id" -> "ENTITY";
            default -> attribute.toUpperCase(Locale.ROOT);
        };
    }
}
