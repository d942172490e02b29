package org.auvsim.auvsml.mapping;

import java.lang.invoke.MethodHandle;
import java.util.Map;
import java.util.Optional;

/**
 * One component of a record type and how it stands in XML.
 *
 * @param index its place among the components
 * @param name its name in XML; of a component that is an interface, only for sentences
 * @param getter from the record to the value, as (Object)Object
 * @param unit of its number or numbers, if stated
 */
record Slot(
        int index,
        String name,
        MethodHandle getter,
        Presence presence,
        Content content,
        Optional<String> unit) {

    /** What a slot holds. */
    sealed interface Content {}

    /** A value in an attribute. */
    record Attribute(ScalarCodec codec) implements Content {}

    /** A record, or a list of them, in elements of the component's name. */
    record Elements(Class<?> type) implements Content {}

    /**
     * Records that implement an interface, in elements of their own names.
     *
     * @param byName the known implementations
     */
    record Choice(Class<?> type, Map<String, Class<?>> byName) implements Content {}

    boolean isAttribute() {
        return content instanceof Attribute;
    }

    boolean isRequired() {
        return presence instanceof Presence.Required;
    }

    boolean isMany() {
        return presence instanceof Presence.Many;
    }
}
