package org.auvsim.auvsml.recording;

import org.auvsim.core.description.ElementName;

import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The records that entries of a recording are, by the names of their elements. */
public final class EntryTypes {
    private static final Map<String, Class<? extends Entry>> BY_NAME =
            records(Entry.class)
                    .collect(
                            Collectors.toMap(
                                    ElementName::of, type -> type, (one, _) -> one, TreeMap::new));

    private EntryTypes() {}

    /** The record of this element. */
    public static Optional<Class<? extends Entry>> named(String element) {
        return Optional.ofNullable(BY_NAME.get(element));
    }

    /** The names of all elements, in their order. */
    public static Collection<String> names() {
        return Collections.unmodifiableCollection(BY_NAME.keySet());
    }

    /** All records, in order of their elements' names. */
    public static Collection<Class<? extends Entry>> all() {
        return Collections.unmodifiableCollection(BY_NAME.values());
    }

    private static Stream<Class<? extends Entry>> records(Class<? extends Entry> type) {
        return type.isRecord()
                ? Stream.of(type)
                : Arrays.stream(type.getPermittedSubclasses())
                        .flatMap(inner -> records(inner.asSubclass(Entry.class)));
    }
}
