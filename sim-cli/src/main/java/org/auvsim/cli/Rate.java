package org.auvsim.cli;

import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

import java.util.Iterator;
import java.util.List;
import java.util.OptionalDouble;

/** World seconds a second; empty: as fast as possible. */
record Rate(OptionalDouble factor) {
    /** As fast as the world's own clocks. */
    static final Rate REAL_TIME = new Rate(OptionalDouble.of(1));

    /** Reads {@code realtime}, {@code max} or a number above 0. */
    static final class Converter implements ITypeConverter<Rate> {
        @Override
        public Rate convert(String text) {
            return switch (text) {
                case "realtime" -> REAL_TIME;
                case "max" -> new Rate(OptionalDouble.empty());
                default -> new Rate(OptionalDouble.of(number(text)));
            };
        }

        private static double number(String text) {
            try {
                double number = Double.parseDouble(text);
                if (number > 0 && number < 1e9) {
                    return number;
                }
            } catch (NumberFormatException _) {
                // said below
            }
            throw new TypeConversionException(
                    "expected realtime, max or a number above 0, but found '" + text + "'");
        }
    }

    /** What a shell can complete. */
    static final class Names implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return List.of("realtime", "max").iterator();
        }
    }
}
