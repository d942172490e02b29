package org.auvsim.auvsml.mapping;

import org.auvsim.auvsml.xml.XmlText;
import org.auvsim.core.description.ElementName;
import org.auvsim.core.math.Numbers;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Writes the XML schema (XSD 1.0) of messages and documents from their records.
 *
 * <p>Elements may stand in any order, as readers take them. Where an element may repeat, XSD 1.0
 * can then not say how often each must stand; that is left to the mapper.
 */
public final class SchemaWriter {
    private static final String NUMBER = "number";
    private static final String NUMBERS = "numbers";
    private static final String MESSAGES = "messages";

    private static final Map<Class<?>, String> SCALARS =
            Map.of(
                    Boolean.class, "xs:boolean",
                    Integer.class, "xs:int",
                    Long.class, "xs:long",
                    Double.class, NUMBER,
                    Numbers.class, NUMBERS,
                    String.class, "xs:string");

    private final MessageCatalogue catalogue;
    private final XmlText out = XmlText.indented();
    private final Map<String, Class<?>> records = new TreeMap<>();
    private final Map<String, Class<?>> enums = new TreeMap<>();
    private final Map<Class<?>, String> names = new HashMap<>();

    private SchemaWriter(MessageCatalogue catalogue) {
        this.catalogue = catalogue;
    }

    /**
     * The schema of all messages of a catalogue, and of documents whose roots are these records.
     */
    public static String write(MessageCatalogue catalogue, List<Class<?>> documents) {
        SchemaWriter writer = new SchemaWriter(catalogue);
        writer.collect(catalogue.types());
        writer.collect(documents);
        writer.schema(documents);
        return writer.out + "\n";
    }

    private void collect(Collection<Class<?>> roots) {
        Deque<Class<?>> open = new ArrayDeque<>(roots);
        while (!open.isEmpty()) {
            Class<?> type = open.pop();
            if (!names.containsKey(type)) {
                name(type, records);
                RecordCodec codec = catalogue.mapper().codec(type);
                codec.slots().forEach(this::collectEnum);
                open.addAll(codec.childTypes());
            }
        }
    }

    private void collectEnum(Slot slot) {
        if (slot.content() instanceof Slot.Attribute(ScalarCodec codec)
                && codec.type().isEnum()
                && !names.containsKey(codec.type())) {
            name(codec.type(), enums);
        }
    }

    /** Types of one simple name in two packages are told apart by the package. */
    private void name(Class<?> type, Map<String, Class<?>> kind) {
        String name = ElementName.of(type);
        if (records.containsKey(name)
                || enums.containsKey(name)
                || name.equals(NUMBER)
                || name.equals(NUMBERS)
                || name.equals(MESSAGES)) {
            name = type.getName().replace('$', '.');
        }
        kind.put(name, type);
        names.put(type, name);
    }

    private void schema(List<Class<?>> documents) {
        out.open("xs:schema");
        out.attribute("xmlns:xs", "http://www.w3.org/2001/XMLSchema");
        for (String root : MessageCatalogue.roots()) {
            begin("xs:element", root, MESSAGES);
            out.close("xs:element");
        }
        for (Class<?> document : documents) {
            element(ElementName.of(document), document);
        }
        messages();
        records.forEach(this::record);
        enums.forEach(this::enumeration);
        number();
        numbers();
        out.close("xs:schema");
    }

    private void messages() {
        out.open("xs:complexType");
        out.attribute("name", MESSAGES);
        out.open("xs:choice");
        out.attribute("maxOccurs", "unbounded");
        for (Class<?> message : catalogue.types()) {
            element(ElementName.of(message), message);
        }
        out.close("xs:choice");
        begin("xs:attribute", MessageCatalogue.REQUEST_ID, "xs:string");
        out.close("xs:attribute");
        out.close("xs:complexType");
    }

    private void record(String name, Class<?> type) {
        List<Slot> slots = catalogue.mapper().codec(type).slots();
        out.open("xs:complexType");
        out.attribute("name", name);
        elements(slots.stream().filter(slot -> !slot.isAttribute()).toList());
        for (Slot slot : slots) {
            if (slot.content() instanceof Slot.Attribute(ScalarCodec codec)) {
                attribute(slot, codec);
            }
        }
        out.close("xs:complexType");
    }

    private void elements(List<Slot> slots) {
        if (slots.isEmpty()) {
            return;
        }
        boolean eachOnce =
                slots.stream().allMatch(s -> !s.isMany() && s.content() instanceof Slot.Elements);
        String group = eachOnce ? "xs:all" : "xs:choice";
        out.open(group);
        if (!eachOnce) {
            out.attribute("minOccurs", "0");
            out.attribute("maxOccurs", "unbounded");
        }
        for (Slot slot : slots) {
            switch (slot.content()) {
                case Slot.Elements(Class<?> type) ->
                        element(slot, type, eachOnce && !slot.isRequired());
                case Slot.Choice(_, Map<String, Class<?>> byName) -> byName.forEach(this::element);
                case Slot.Attribute _ -> throw new IllegalStateException("not an element");
            }
        }
        out.close(group);
    }

    private void element(String name, Class<?> type) {
        begin("xs:element", name, typeName(type));
        out.close("xs:element");
    }

    private void element(Slot slot, Class<?> type, boolean mayBeMissing) {
        begin("xs:element", slot.name(), typeName(type));
        if (mayBeMissing) {
            out.attribute("minOccurs", "0");
        }
        unit(slot);
        out.close("xs:element");
    }

    private void begin(String what, String name, String type) {
        out.open(what);
        out.attribute("name", name);
        out.attribute("type", type);
    }

    private String typeName(Class<?> type) {
        String name = SCALARS.getOrDefault(type, names.get(type));
        if (name == null) {
            throw new IllegalStateException("no schema type for " + type.getName());
        }
        return name;
    }

    private void attribute(Slot slot, ScalarCodec codec) {
        begin("xs:attribute", slot.name(), typeName(codec.type()));
        if (slot.isRequired()) {
            out.attribute("use", "required");
        } else if (slot.presence() instanceof Presence.Defaulted(Object value)) {
            codec.writer().write(value, out.attribute("default"));
            out.endAttribute();
        }
        unit(slot);
        out.close("xs:attribute");
    }

    private void unit(Slot slot) {
        slot.unit()
                .ifPresent(
                        unit -> {
                            out.open("xs:annotation");
                            out.element("xs:documentation", "unit: " + unit);
                            out.close("xs:annotation");
                        });
    }

    private void enumeration(String name, Class<?> type) {
        out.open("xs:simpleType");
        out.attribute("name", name);
        out.open("xs:restriction");
        out.attribute("base", "xs:string");
        for (Object constant : type.getEnumConstants()) {
            out.open("xs:enumeration");
            out.attribute("value", constant.toString());
            out.close("xs:enumeration");
        }
        out.close("xs:restriction");
        out.close("xs:simpleType");
    }

    /** A double, but neither NaN nor infinite. */
    private void number() {
        out.open("xs:simpleType");
        out.attribute("name", NUMBER);
        out.open("xs:restriction");
        out.attribute("base", "xs:double");
        out.open("xs:pattern");
        out.attribute("value", "[+\\-]?([0-9]+(\\.[0-9]*)?|\\.[0-9]+)([eE][+\\-]?[0-9]+)?");
        out.close("xs:pattern");
        out.close("xs:restriction");
        out.close("xs:simpleType");
    }

    private void numbers() {
        out.open("xs:simpleType");
        out.attribute("name", NUMBERS);
        out.open("xs:list");
        out.attribute("itemType", NUMBER);
        out.close("xs:list");
        out.close("xs:simpleType");
    }
}
