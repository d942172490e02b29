package org.auvsim.auvsml.mapping;

import ch.randelshofer.fastdoubleparser.JavaDoubleParser;

import org.auvsim.auvsml.xml.XmlText;
import org.auvsim.core.math.Numbers;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A kind of value that stands in an attribute.
 *
 * @param type the Java type, boxed
 * @param expected what a sentence calls it: "a finite number"
 * @param reader from the attribute's text; throws IllegalArgumentException for anything else
 * @param writer to the attribute's text; throws IllegalArgumentException for what has none
 */
record ScalarCodec(Class<?> type, String expected, Reader reader, Writer writer) {
    /** Reads a value. */
    interface Reader {
        Object read(String text);
    }

    /** Writes a value, escaped. */
    interface Writer {
        void write(Object value, StringBuilder out);
    }

    private static final Map<Class<?>, ScalarCodec> BY_TYPE =
            Map.ofEntries(
                    entry(
                            boolean.class,
                            Boolean.class,
                            "1 or 0",
                            ScalarCodec::readBoolean,
                            (value, out) -> out.append((boolean) value ? '1' : '0')),
                    entry(
                            int.class,
                            Integer.class,
                            "a whole number",
                            Integer::valueOf,
                            (value, out) -> out.append((int) value)),
                    entry(
                            long.class,
                            Long.class,
                            "a whole number",
                            Long::valueOf,
                            (value, out) -> out.append((long) value)),
                    entry(
                            double.class,
                            Double.class,
                            "a finite number",
                            ScalarCodec::readDouble,
                            ScalarCodec::writeDouble),
                    entry(
                            Numbers.class,
                            Numbers.class,
                            "finite numbers with blanks between them",
                            ScalarCodec::readNumbers,
                            ScalarCodec::writeNumbers),
                    entry(
                            String.class,
                            String.class,
                            "a text",
                            text -> text,
                            ScalarCodec::writeText));

    private static Map.Entry<Class<?>, ScalarCodec> entry(
            Class<?> type, Class<?> boxed, String expected, Reader reader, Writer writer) {
        return Map.entry(type, new ScalarCodec(boxed, expected, reader, writer));
    }

    /** The codec of a component's type; empty if such a value is not an attribute. */
    static Optional<ScalarCodec> of(Class<?> type) {
        return type.isEnum() ? Optional.of(ofEnum(type)) : Optional.ofNullable(BY_TYPE.get(type));
    }

    private static ScalarCodec ofEnum(Class<?> type) {
        List<?> constants = Arrays.asList(type.getEnumConstants());
        List<String> names = constants.stream().map(Object::toString).toList();
        return new ScalarCodec(
                type,
                names.size() < 10 ? "one of " + String.join(", ", names) : "a known name",
                text -> {
                    int i = names.indexOf(text);
                    if (i < 0) {
                        throw new IllegalArgumentException(text);
                    }
                    return constants.get(i);
                },
                (value, out) -> out.append(value));
    }

    /** The sentence for a text that {@link #reader} refuses. */
    String refusal(String found) {
        return "expected " + expected + ", but found " + Names.quoted(found);
    }

    private static Object readBoolean(String text) {
        return switch (text) {
            case "1", "true" -> true;
            case "0", "false" -> false;
            default -> throw new IllegalArgumentException(text);
        };
    }

    /** Decimal numbers alone: what Java reads beyond them (hexadecimal, "1d", "NaN") is refused. */
    private static Object readDouble(String text) {
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            if ((c < '0' || c > '9') && c != '.' && c != '-' && c != '+' && c != 'e' && c != 'E') {
                throw new IllegalArgumentException(text);
            }
        }
        double value = JavaDoubleParser.parseDouble(text);
        if (Double.isInfinite(value)) {
            throw new IllegalArgumentException(text);
        }
        return value;
    }

    private static void writeDouble(Object value, StringBuilder out) {
        double number = (double) value;
        if (!Double.isFinite(number)) {
            throw new IllegalArgumentException("expected a finite number, but it is " + number);
        }
        out.append(number);
    }

    private static Object readNumbers(String text) {
        String[] words = text.strip().split("\\s+", -1);
        double[] values = new double[words.length];
        for (int i = 0; i < words.length; i++) {
            values[i] = (double) readDouble(words[i]);
        }
        return Numbers.of(values);
    }

    private static void writeNumbers(Object value, StringBuilder out) {
        Numbers numbers = (Numbers) value;
        if (numbers.size() == 0) {
            throw new IllegalArgumentException("expected at least one number, but there is none");
        }
        for (int i = 0; i < numbers.size(); i++) {
            if (i > 0) {
                out.append(' ');
            }
            writeDouble(numbers.get(i), out);
        }
    }

    private static void writeText(Object value, StringBuilder out) {
        String text = (String) value;
        for (int i = 0; i < text.length(); ) {
            int c = text.codePointAt(i);
            if (!isXml(c)) {
                throw new IllegalArgumentException(
                        "XML cannot hold the character U+%04X of %s"
                                .formatted(c, Names.quoted(text)));
            }
            i += Character.charCount(c);
        }
        XmlText.escape(text, out);
    }

    private static boolean isXml(int c) {
        return (c >= 0x20 && c <= 0xD7FF)
                || c == '\t'
                || c == '\n'
                || c == '\r'
                || (c >= 0xE000 && c <= 0xFFFD)
                || c >= 0x10000;
    }
}
