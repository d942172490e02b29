package org.auvsim.auvsml.mapping;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.xml.PlacedElement;
import org.auvsim.auvsml.xml.XmlText;
import org.auvsim.auvsml.xml.XmlTree;
import org.auvsim.core.description.ElementName;
import org.jspecify.annotations.Nullable;

import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Maps records to XML and back; see the package for the rules. Plans are compiled once a type. One
 * mapper may be used by many threads.
 */
public final class AuvsmlMapper {
    private final ClassLoader loader;
    private final Map<Class<?>, Map<String, Class<?>>> registered;
    private final Map<Class<?>, Map<String, Class<?>>> implementations = new ConcurrentHashMap<>();
    private final Map<Class<?>, RecordCodec> codecs = new ConcurrentHashMap<>();

    private AuvsmlMapper(Builder builder) {
        this.loader = builder.loader;
        this.registered = builder.registered;
    }

    /** A mapper that knows the implementations that {@code loader}'s provider files name. */
    public static AuvsmlMapper load(ClassLoader loader) {
        return builder(loader).build();
    }

    /** Collects implementations beside those that {@code loader}'s provider files name. */
    public static Builder builder(ClassLoader loader) {
        return new Builder(loader);
    }

    /**
     * The record that a text's root element states, whose name must be the record's.
     *
     * @throws AuvsmlException with every fault of the text
     */
    public <R> R decode(Class<R> type, XmlTree tree) throws AuvsmlException {
        String expected = codec(type).elementName();
        PlacedElement root = tree.root();
        if (!root.getName().equals(expected)) {
            throw new AuvsmlException(
                    new Fault(
                            ErrorCode.UNKNOWN_ROOT,
                            "expected the root element <%s>, but found <%s>"
                                    .formatted(expected, root.getName()),
                            root.getName(),
                            root.place().line(),
                            root.place().column()));
        }
        Decoding decoding = new Decoding(tree, false);
        Object record = codec(type).decode(root, decoding);
        if (record == null) {
            throw new AuvsmlException(decoding.faults());
        }
        return type.cast(record);
    }

    /** A record as an indented text, its element named after its type. */
    public String encode(Record record) {
        XmlText out = XmlText.indented();
        encode(record, out);
        return out + "\n";
    }

    /** A record as one line in UTF-8, with a line feed at its end. */
    public byte[] encodeLine(Record record) {
        XmlText out = XmlText.compact();
        encode(record, out);
        return out.toBytes();
    }

    /**
     * Writes a record as an element named after its type.
     *
     * @throws IllegalArgumentException if a number is not finite or a text is not XML's
     */
    void encode(Object record, XmlText out) {
        RecordCodec codec = codec(record.getClass());
        codec.encode(codec.elementName(), record, out);
    }

    /**
     * A record of a type that states nothing, each component as its default has it; empty if one of
     * them is needed, or the record refuses to be so.
     */
    public <R> Optional<R> withDefaults(Class<R> type) {
        RecordCodec codec = codec(type);
        @Nullable Object[] values = new @Nullable Object[codec.slots().size()];
        for (Slot slot : codec.slots()) {
            Object value = slot.presence().complete(null);
            if (value == null) {
                return Optional.empty();
            }
            values[slot.index()] = value;
        }
        try {
            return Optional.of(type.cast(codec.create(values)));
        } catch (IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    /** The record types that stand for an interface, by element name, in its order. */
    public Map<String, Class<?>> implementations(Class<?> type) {
        return implementations.computeIfAbsent(type, this::collect);
    }

    private Map<String, Class<?>> collect(Class<?> type) {
        Map<String, Class<?>> byName = new TreeMap<>(registered.getOrDefault(type, Map.of()));
        for (Class<?> provider : ProviderFile.read(type, loader)) {
            put(byName, type, provider);
        }
        return Collections.unmodifiableMap(byName);
    }

    private static void put(Map<String, Class<?>> byName, Class<?> type, Class<?> record) {
        String name = ElementName.of(record);
        Class<?> other = byName.put(name, record);
        if (other != null && other != record) {
            throw new IllegalArgumentException(
                    "%s and %s are both registered as %s <%s>; rename one of the records"
                            .formatted(other.getName(), record.getName(), type.getName(), name));
        }
    }

    /**
     * The one element that takes elements of a name to choose from, of those that are themselves
     * chosen by name; empty if none does, or several do.
     */
    Optional<String> homeOf(String name) {
        List<String> homes =
                implementations.values().stream()
                        .flatMap(byName -> byName.values().stream())
                        .distinct()
                        .map(this::codec)
                        .filter(codec -> codec.chooses(name))
                        .map(RecordCodec::elementName)
                        .toList();
        return homes.size() == 1 ? Optional.of(homes.getFirst()) : Optional.empty();
    }

    /** The codec of a record type, compiled with all types inside it when first asked for. */
    RecordCodec codec(Class<?> type) {
        RecordCodec codec = codecs.get(type);
        return codec == null ? compile(type) : codec;
    }

    private RecordCodec compile(Class<?> type) {
        RecordCodec codec = new RecordCompiler(this).compile(type);
        @Nullable RecordCodec earlier = codecs.putIfAbsent(type, codec);
        if (earlier != null) {
            return earlier;
        }
        codec.childTypes().forEach(this::codec);
        return codec;
    }

    /** Collects implementations of interfaces. */
    public static final class Builder {
        private final ClassLoader loader;
        private final Map<Class<?>, Map<String, Class<?>>> registered = new HashMap<>();

        private Builder(ClassLoader loader) {
            this.loader = loader;
        }

        /**
         * Makes a record type known as one that may stand where {@code type} is asked for.
         *
         * @throws IllegalArgumentException if another one with the same element name is known
         */
        public <I> Builder register(Class<I> type, Class<? extends I> record) {
            put(registered.computeIfAbsent(type, _ -> new TreeMap<>()), type, record);
            return this;
        }

        /** The mapper. */
        public AuvsmlMapper build() {
            return new AuvsmlMapper(this);
        }
    }
}
