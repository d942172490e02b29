package org.auvsim.auvsml.mapping;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.xml.PlacedElement;
import org.auvsim.auvsml.xml.XmlText;
import org.auvsim.core.description.ElementName;
import org.jdom2.Attribute;
import org.jdom2.Content;
import org.jdom2.Text;
import org.jspecify.annotations.Nullable;

import java.lang.invoke.MethodHandle;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Reads and writes one record type; built once a type, then two short loops a record. */
final class RecordCodec {
    /** Stands where a value was given that could not be read, so that it is not missing too. */
    private enum Unreadable {
        VALUE
    }

    private final AuvsmlMapper mapper;
    private final Class<?> type;
    private final String elementName;
    private final List<Slot> slots;
    private final List<Slot> attributeSlots;
    private final List<Slot> elementSlots;
    private final MethodHandle constructor;
    private final Map<String, Slot> attributes = new HashMap<>();
    private final Map<String, Child> children = new HashMap<>();

    /** What a child element's name means: a record for a slot. */
    private record Child(Slot slot, Class<?> type) {}

    /**
     * A codec of these slots.
     *
     * @param constructor from an array of the components' values, as (Object[])Object
     * @throws IllegalArgumentException if two slots claim one name
     */
    RecordCodec(AuvsmlMapper mapper, Class<?> type, List<Slot> slots, MethodHandle constructor) {
        this.mapper = mapper;
        this.type = type;
        this.elementName = ElementName.of(type);
        this.slots = slots;
        this.attributeSlots = slots.stream().filter(Slot::isAttribute).toList();
        this.elementSlots = slots.stream().filter(slot -> !slot.isAttribute()).toList();
        this.constructor = constructor;
        for (Slot slot : slots) {
            switch (slot.content()) {
                case Slot.Attribute _ -> attributes.put(slot.name(), slot);
                case Slot.Elements elements -> claim(slot.name(), new Child(slot, elements.type()));
                case Slot.Choice choice ->
                        choice.byName().forEach((name, of) -> claim(name, new Child(slot, of)));
            }
        }
    }

    private void claim(String name, Child child) {
        Child other = children.put(name, child);
        if (other != null) {
            throw new IllegalArgumentException(
                    "in record %s, components '%s' and '%s' would both be elements <%s>"
                            .formatted(type.getName(), other.slot.name(), child.slot.name(), name));
        }
    }

    Class<?> type() {
        return type;
    }

    /** The element's name where no component names it. */
    String elementName() {
        return elementName;
    }

    List<Slot> slots() {
        return slots;
    }

    /** The record types of the elements inside. */
    Set<Class<?>> childTypes() {
        Set<Class<?>> types = new LinkedHashSet<>();
        children.values().forEach(child -> types.add(child.type));
        return types;
    }

    /** The record; null if anything is wrong, which {@code decoding} then knows. */
    @Nullable Object decode(PlacedElement element, Decoding decoding) {
        int before = decoding.faultCount();
        @Nullable Object[] values = new @Nullable Object[slots.size()];
        readAttributes(element, values, decoding);
        readContent(element, values, decoding);
        complete(element, values, decoding);
        return decoding.faultCount() == before ? construct(element, values, decoding) : null;
    }

    private void readAttributes(
            PlacedElement element, @Nullable Object[] values, Decoding decoding) {
        if (!element.hasAttributes()) {
            return;
        }
        List<Attribute> given = element.getAttributes();
        for (int i = 0; i < given.size(); i++) {
            Attribute attribute = given.get(i);
            Slot slot = attributes.get(attribute.getName());
            if (slot != null) {
                values[slot.index()] = readScalar(slot, attribute, element, decoding);
            } else if (!decoding.isLenient()) {
                decoding.fault(
                        ErrorCode.UNKNOWN_ATTRIBUTE,
                        "<%s> has no attribute %s; %s"
                                .formatted(
                                        element.getName(),
                                        Names.quoted(attribute.getName()),
                                        Names.nearest(attribute.getName(), attributes.keySet())),
                        element,
                        attribute.getName());
            }
        }
    }

    private static Object readScalar(
            Slot slot, Attribute attribute, PlacedElement element, Decoding decoding) {
        ScalarCodec codec = ((Slot.Attribute) slot.content()).codec();
        try {
            return codec.reader().read(attribute.getValue());
        } catch (IllegalArgumentException _) {
            decoding.fault(
                    ErrorCode.INVALID_VALUE,
                    codec.refusal(attribute.getValue()),
                    element,
                    attribute.getName());
            return Unreadable.VALUE;
        }
    }

    private void readContent(PlacedElement element, @Nullable Object[] values, Decoding decoding) {
        int size = element.getContentSize();
        for (int i = 0; i < size; i++) {
            Content content = element.getContent(i);
            if (content instanceof PlacedElement inner) {
                readChild(inner, values, decoding);
            } else if (content instanceof Text text && !decoding.isLenient()) {
                decoding.fault(
                        ErrorCode.INVALID_VALUE,
                        "expected no text in <%s>, but found %s"
                                .formatted(element.getName(), Names.quoted(text.getTextTrim())),
                        element);
            }
        }
    }

    private void readChild(PlacedElement inner, @Nullable Object[] values, Decoding decoding) {
        Child child = children.get(inner.getName());
        if (child == null) {
            unknownChild(inner, decoding);
            return;
        }
        int index = child.slot.index();
        if (!child.slot.isMany() && values[index] != null) {
            decoding.fault(
                    ErrorCode.DUPLICATE_ELEMENT,
                    "expected one %s, but here is another".formatted(child.slot.name()),
                    inner);
            return;
        }
        Object value = mapper.codec(child.type).decode(inner, decoding);
        if (child.slot.isMany()) {
            append(values, index, value);
        } else {
            values[index] = value == null ? Unreadable.VALUE : value;
        }
    }

    private static void append(@Nullable Object[] values, int index, @Nullable Object value) {
        @SuppressWarnings("unchecked") // only this method fills slots that take many
        List<Object> list = (List<Object>) values[index];
        if (list == null) {
            list = new ArrayList<>();
            values[index] = list;
        }
        if (value != null) {
            list.add(value);
        }
    }

    private void unknownChild(PlacedElement inner, Decoding decoding) {
        if (!decoding.isLenient()) {
            String problem =
                    mapper.homeOf(inner.getName())
                            .map(
                                    home ->
                                            "<%s> belongs inside <%s>, but is inside <%s>"
                                                    .formatted(
                                                            inner.getName(),
                                                            home,
                                                            inner.getParentElement().getName()))
                            .orElseGet(
                                    () ->
                                            "unknown element %s; %s"
                                                    .formatted(
                                                            Names.quoted(inner.getName()),
                                                            Names.nearest(
                                                                    inner.getName(),
                                                                    children.keySet())));
            decoding.fault(ErrorCode.UNKNOWN_ELEMENT, problem, inner);
        }
    }

    /** Whether an element of this name may be chosen inside. */
    boolean chooses(String name) {
        Child child = children.get(name);
        return child != null && child.slot.content() instanceof Slot.Choice;
    }

    private void complete(PlacedElement element, @Nullable Object[] values, Decoding decoding) {
        for (Slot slot : slots) {
            Object value = values[slot.index()];
            if (value instanceof Unreadable) {
                continue;
            }
            values[slot.index()] = slot.presence().complete(value);
            if (values[slot.index()] == null) {
                decoding.fault(ErrorCode.MISSING_VALUE, missing(element, slot), element);
            }
        }
    }

    private static String missing(PlacedElement element, Slot slot) {
        return switch (slot.content()) {
            case Slot.Attribute attribute ->
                    "<%s> needs an attribute '%s', %s"
                            .formatted(
                                    element.getName(), slot.name(), attribute.codec().expected());
            case Slot.Elements _ ->
                    "<%s> needs an element <%s>".formatted(element.getName(), slot.name());
            case Slot.Choice choice ->
                    "<%s> needs a %s: one of the elements %s"
                            .formatted(
                                    element.getName(),
                                    slot.name(),
                                    String.join(", ", choice.byName().keySet()));
        };
    }

    private @Nullable Object construct(
            PlacedElement element, @Nullable Object[] values, Decoding decoding) {
        try {
            return create(values);
        } catch (IllegalArgumentException e) {
            decoding.fault(ErrorCode.INVALID_VALUE, String.valueOf(e.getMessage()), element);
            return null;
        }
    }

    /** The record of these components; throws IllegalArgumentException as its constructor does. */
    Object create(@Nullable Object[] values) {
        try {
            return (Object) constructor.invokeExact(values);
        } catch (RuntimeException | Error e) {
            throw e;
        } catch (Throwable e) {
            throw new IllegalStateException("constructor of " + type.getName() + " failed", e);
        }
    }

    /** Writes a record as an element of this name. */
    void encode(String name, Object record, XmlText out) {
        out.open(name);
        for (Slot slot : attributeSlots) {
            Object value = slot.presence().written(value(slot, record));
            if (value != null) {
                encodeAttribute(name, slot, value, out);
            }
        }
        for (Slot slot : elementSlots) {
            Object value = slot.presence().written(value(slot, record));
            if (value != null) {
                encodeElements(slot, value, out);
            }
        }
        out.close(name);
    }

    private static void encodeAttribute(String name, Slot slot, Object value, XmlText out) {
        try {
            ((Slot.Attribute) slot.content())
                    .codec()
                    .writer()
                    .write(value, out.attribute(slot.name()));
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(
                    "<%s> cannot be written: its %s is wrong: %s"
                            .formatted(name, slot.name(), e.getMessage()),
                    e);
        }
        out.endAttribute();
    }

    private void encodeElements(Slot slot, Object value, XmlText out) {
        if (value instanceof List<?> list) {
            for (Object each : list) {
                encodeElements(slot, each, out);
            }
        } else {
            RecordCodec codec = mapper.codec(value.getClass());
            boolean named = slot.content() instanceof Slot.Elements;
            codec.encode(named ? slot.name() : codec.elementName, value, out);
        }
    }

    /** The value of a component. */
    static Object value(Slot slot, Object record) {
        try {
            return (Object) slot.getter().invokeExact(record);
        } catch (RuntimeException | Error e) {
            throw e;
        } catch (Throwable e) {
            throw new IllegalStateException("component " + slot.name() + " failed", e);
        }
    }
}
