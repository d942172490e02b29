package org.auvsim.auvsml.mapping;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.ElementName;
import org.auvsim.core.description.Name;
import org.auvsim.core.description.Unit;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
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

/** Turns a record type into its codec: the one place that reflects. */
final class RecordCompiler {
    private final AuvsmlMapper mapper;

    RecordCompiler(AuvsmlMapper mapper) {
        this.mapper = mapper;
    }

    /**
     * The codec of a record type.
     *
     * @throws IllegalArgumentException if it is no record or has a component that AUVSML has no
     *     form for
     */
    RecordCodec compile(Class<?> type) {
        RecordComponent[] components = type.getRecordComponents();
        if (components == null) {
            throw new IllegalArgumentException(type.getName() + " is not a record");
        }
        try {
            MethodHandles.Lookup lookup =
                    MethodHandles.privateLookupIn(type, MethodHandles.lookup());
            List<Slot> slots = new ArrayList<>();
            for (RecordComponent component : components) {
                slots.add(slot(slots.size(), component, lookup));
            }
            return new RecordCodec(
                    mapper, type, List.copyOf(slots), constructor(type, components, lookup));
        } catch (ReflectiveOperationException e) {
            throw new IllegalArgumentException(
                    "record " + type.getName() + " cannot be reached: " + e.getMessage(), e);
        }
    }

    private static MethodHandle constructor(
            Class<?> type, RecordComponent[] components, MethodHandles.Lookup lookup)
            throws ReflectiveOperationException {
        Class<?>[] types =
                Arrays.stream(components).map(RecordComponent::getType).toArray(Class<?>[]::new);
        return lookup.findConstructor(type, MethodType.methodType(void.class, types))
                .asSpreader(Object[].class, types.length)
                .asType(MethodType.methodType(Object.class, Object[].class));
    }

    private Slot slot(int index, RecordComponent component, MethodHandles.Lookup lookup)
            throws ReflectiveOperationException {
        Slot.Content content = content(component);
        Presence presence = presence(component, content);
        if (presence instanceof Presence.Many && content instanceof Slot.Attribute) {
            throw unsupported(component, "a list of scalars; make it a list of records");
        }
        return new Slot(
                index,
                name(component),
                lookup.unreflect(component.getAccessor())
                        .asType(MethodType.methodType(Object.class, Object.class)),
                presence,
                content,
                Optional.ofNullable(component.getAnnotation(Unit.class)).map(Unit::value));
    }

    private static String name(RecordComponent component) {
        Name stated = component.getAnnotation(Name.class);
        return stated == null ? ElementName.of(component.getName()) : stated.value();
    }

    private Presence presence(RecordComponent component, Slot.Content content) {
        Class<?> type = component.getType();
        Default byDefault = component.getAnnotation(Default.class);
        if (byDefault != null) {
            return new Presence.Defaulted(defaultValue(component, byDefault.value(), content));
        }
        if (type == List.class) {
            return new Presence.Many();
        }
        if (type == Optional.class) {
            return new Presence.InOptional();
        }
        if (type == OptionalDouble.class) {
            return new Presence.InOptionalDouble();
        }
        if (type == OptionalLong.class) {
            return new Presence.InOptionalLong();
        }
        return type == OptionalInt.class ? new Presence.InOptionalInt() : new Presence.Required();
    }

    private Object defaultValue(RecordComponent component, String text, Slot.Content content) {
        try {
            return new DefaultText(mapper, text).value(content);
        } catch (IllegalArgumentException e) {
            throw unsupported(component, "the default '" + text + "', " + e.getMessage());
        }
    }

    private Slot.Content content(RecordComponent component) {
        Class<?> type = valueType(component);
        Optional<ScalarCodec> scalar = ScalarCodec.of(type);
        if (scalar.isPresent()) {
            return new Slot.Attribute(scalar.get());
        }
        if (type.isRecord()) {
            return new Slot.Elements(type);
        }
        if (type.isInterface() && !type.getName().startsWith("java.")) {
            return new Slot.Choice(type, mapper.implementations(type));
        }
        throw unsupported(component, "a " + type.getName());
    }

    /** The type inside a list or optional, else the component's own. */
    private static Class<?> valueType(RecordComponent component) {
        Class<?> type = component.getType();
        if (type == OptionalDouble.class) {
            return double.class;
        }
        if (type == OptionalLong.class) {
            return long.class;
        }
        if (type == OptionalInt.class) {
            return int.class;
        }
        if (type != List.class && type != Optional.class) {
            return type;
        }
        Type argument =
                ((ParameterizedType) component.getGenericType()).getActualTypeArguments()[0];
        return argument instanceof Class<?> inner ? primitive(inner) : rawType(component, argument);
    }

    private static Class<?> primitive(Class<?> boxed) {
        return MethodType.methodType(boxed).unwrap().returnType();
    }

    private static Class<?> rawType(RecordComponent component, Type argument) {
        if (argument instanceof ParameterizedType generic
                && generic.getRawType() instanceof Class<?> raw) {
            return raw;
        }
        throw unsupported(component, "a " + argument.getTypeName());
    }

    private static IllegalArgumentException unsupported(RecordComponent component, String what) {
        return new IllegalArgumentException(
                "component %s of record %s cannot be written in AUVSML: it has %s"
                        .formatted(
                                component.getName(),
                                component.getDeclaringRecord().getName(),
                                what));
    }
}
