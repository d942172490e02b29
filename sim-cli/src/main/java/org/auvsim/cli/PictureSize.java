package org.auvsim.cli;

import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** How large a picture is (pixels). */
record PictureSize(int width, int height) {
    private static final int MOST = 8192;

    /** Reads {@code 1280x800}. */
    static final class Converter implements ITypeConverter<PictureSize> {
        private static final Pattern FORM = Pattern.compile("([0-9]{1,5})x([0-9]{1,5})");

        @Override
        public PictureSize convert(String text) {
            Matcher parts = FORM.matcher(text);
            if (parts.matches()) {
                int width = Integer.parseInt(parts.group(1));
                int height = Integer.parseInt(parts.group(2));
                if (width >= 1 && width <= MOST && height >= 1 && height <= MOST) {
                    return new PictureSize(width, height);
                }
            }
            throw new TypeConversionException(
                    "expected WIDTHxHEIGHT in pixels, 1 to %d each, as 1280x800, but found '%s'"
                            .formatted(MOST, text));
        }
    }
}
