package org.auvsim.auvsml.mapping;

import java.util.Arrays;
import java.util.List;

/**
 * A part of a message, for who writes one by other means than its record.
 *
 * @param name of the attribute; of elements, what they are for
 * @param isAttribute whether it is an attribute; else it is elements
 * @param isRequired whether it may not be left out
 * @param choices the values that the attribute may have, if there are few; the elements' names
 */
public record Part(String name, boolean isAttribute, boolean isRequired, List<String> choices) {
    static Part of(Slot slot) {
        return new Part(
                slot.name(), slot.isAttribute(), slot.isRequired(), choices(slot, slot.content()));
    }

    private static List<String> choices(Slot slot, Slot.Content content) {
        return switch (content) {
            case Slot.Attribute(ScalarCodec codec) -> values(codec.type());
            case Slot.Elements _ -> List.of(slot.name());
            case Slot.Choice choice -> List.copyOf(choice.byName().keySet());
        };
    }

    private static List<String> values(Class<?> scalar) {
        if (scalar == boolean.class) {
            return List.of("1", "0");
        }
        return scalar.isEnum()
                ? Arrays.stream(scalar.getEnumConstants()).map(Object::toString).toList()
                : List.of();
    }
}
