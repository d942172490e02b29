package org.auvsim.cli;

import org.auvsim.core.sensor.SensorReading;

import java.lang.reflect.RecordComponent;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.OptionalLong;

/**
 * The single values of a reading by their names, as {@code velocity.x} or {@code echo.2.distance};
 * what the reading leaves out is not among them.
 */
final class Quantities {
    private final Map<String, String> values = new LinkedHashMap<>();

    private Quantities() {}

    /** Those of a reading, in the order of its components. */
    static Map<String, String> of(SensorReading reading) {
        Quantities quantities = new Quantities();
        quantities.addRecord("", (Record) reading);
        return quantities.values;
    }

    private void addRecord(String prefix, Record record) {
        for (RecordComponent component : record.getClass().getRecordComponents()) {
            add(prefix + component.getName(), value(record, component));
        }
    }

    private static Object value(Record record, RecordComponent component) {
        try {
            component.getAccessor().setAccessible(true);
            return component.getAccessor().invoke(record);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(component + " of a reading cannot be read", e);
        }
    }

    private void add(String name, Object value) {
        switch (value) {
            case Record record -> addRecord(name + ".", record);
            case List<?> list -> {
                for (int i = 0; i < list.size(); i++) {
                    add(name + "." + i, list.get(i));
                }
            }
            case Optional<?> maybe -> maybe.ifPresent(inner -> add(name, inner));
            case OptionalDouble maybe -> maybe.ifPresent(inner -> add(name, inner));
            case OptionalLong maybe -> maybe.ifPresent(inner -> add(name, inner));
            case OptionalInt maybe -> maybe.ifPresent(inner -> add(name, inner));
            default -> values.put(name, value.toString());
        }
    }
}
