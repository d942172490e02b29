package org.auvsim.cli;

import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Where a simulator listens. */
record Address(String host, int port) {
    /** A simulator on this machine that was told nothing else. */
    static final String STANDARD = "127.0.0.1:40001";

    static final int STANDARD_PORT = 40001;

    /** Reads {@code host:port}, {@code host} or {@code :port}; IPv6 addresses in brackets. */
    static final class Converter implements ITypeConverter<Address> {
        private static final Pattern FORM =
                Pattern.compile("(\\[[^\\]]+]|[^:\\[\\]]*)(?::([0-9]{1,9}))?");

        @Override
        public Address convert(String text) {
            Matcher parts = FORM.matcher(text);
            if (text.isEmpty() || !parts.matches()) {
                throw expected(text);
            }
            String port = parts.group(2);
            int number = port == null ? STANDARD_PORT : Integer.parseInt(port);
            if (number < 1 || number > 65535) {
                throw new TypeConversionException(
                        "a port is a number from 1 to 65535, but is %d in '%s'"
                                .formatted(number, text));
            }
            String host = parts.group(1);
            return new Address(host.isEmpty() ? "127.0.0.1" : host, number);
        }

        private static TypeConversionException expected(String text) {
            return new TypeConversionException(
                    "expected host:port, as %s, but found '%s'".formatted(STANDARD, text));
        }
    }
}
