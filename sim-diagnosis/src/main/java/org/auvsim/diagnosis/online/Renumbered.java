package org.auvsim.diagnosis.online;

import org.auvsim.core.entity.Field;

import java.lang.reflect.Constructor;
import java.lang.reflect.RecordComponent;

/** A field under another id: that of one that has left a world is not used again. */
final class Renumbered {
    private Renumbered() {}

    /**
     * The same field but for its id.
     *
     * @throws IllegalArgumentException if it is no record, as those of scenarios are
     */
    static Field<?> field(Field<?> field, long id) {
        if (!(field instanceof Record)) {
            throw new IllegalArgumentException(
                    "the field '%s' gets no other id: %s is not a record"
                            .formatted(field.name(), field.getClass().getName()));
        }
        RecordComponent[] components = field.getClass().getRecordComponents();
        Class<?>[] types = new Class<?>[components.length];
        Object[] values = new Object[components.length];
        try {
            for (int i = 0; i < components.length; i++) {
                components[i].getAccessor().setAccessible(true);
                types[i] = components[i].getType();
                values[i] =
                        components[i].getName().equals("id")
                                ? (Object) id
                                : components[i].getAccessor().invoke(field);
            }
            Constructor<?> canonical = field.getClass().getDeclaredConstructor(types);
            canonical.setAccessible(true);
            return (Field<?>) canonical.newInstance(values);
        } catch (ReflectiveOperationException e) {
            throw new IllegalArgumentException(
                    "the field '%s' gets no other id".formatted(field.name()), e);
        }
    }
}
