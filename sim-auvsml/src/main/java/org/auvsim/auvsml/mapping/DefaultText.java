package org.auvsim.auvsml.mapping;

import org.jspecify.annotations.Nullable;

import java.util.Iterator;
import java.util.List;

/**
 * The text of a {@link org.auvsim.core.description.Default}: one scalar, or those of a nested
 * record in order; for an interface, the element's name comes before them.
 */
final class DefaultText {
    private final AuvsmlMapper mapper;
    private final String text;

    DefaultText(AuvsmlMapper mapper, String text) {
        this.mapper = mapper;
        this.text = text;
    }

    /**
     * The value.
     *
     * @throws IllegalArgumentException if the text does not fit
     */
    Object value(Slot.Content content) {
        if (content instanceof Slot.Attribute attribute) {
            return attribute.codec().reader().read(text);
        }
        Iterator<String> words = List.of(text.strip().split("\\s+")).iterator();
        Object value = value(content, words);
        if (words.hasNext()) {
            throw new IllegalArgumentException("which has more values than are needed");
        }
        return value;
    }

    private Object value(Slot.Content content, Iterator<String> words) {
        return switch (content) {
            case Slot.Attribute attribute -> attribute.codec().reader().read(next(words));
            case Slot.Elements elements -> record(mapper.codec(elements.type()), words);
            case Slot.Choice choice -> {
                String name = next(words);
                Class<?> type = choice.byName().get(name);
                if (type == null) {
                    throw new IllegalArgumentException("where '" + name + "' is unknown");
                }
                yield record(mapper.codec(type), words);
            }
        };
    }

    /** A record of the words that are left; what is left out at the end has its own defaults. */
    private Object record(RecordCodec codec, Iterator<String> words) {
        @Nullable Object[] values = new @Nullable Object[codec.slots().size()];
        for (Slot slot : codec.slots()) {
            Object read = words.hasNext() ? value(slot.content(), words) : null;
            Object value = slot.presence().complete(read);
            if (value == null) {
                throw new IllegalArgumentException("which has fewer values than are needed");
            }
            values[slot.index()] = value;
        }
        return codec.create(values);
    }

    private static String next(Iterator<String> words) {
        if (!words.hasNext()) {
            throw new IllegalArgumentException("which has fewer values than are needed");
        }
        return words.next();
    }
}
