package org.auvsim.diagnosis.reading;

import static java.time.ZoneOffset.UTC;
import static java.time.format.DateTimeFormatter.ISO_LOCAL_DATE;
import static java.time.format.DateTimeFormatter.ISO_LOCAL_TIME;

import java.time.DateTimeException;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.OffsetDateTime;
import java.time.format.DateTimeFormatter;
import java.time.format.DateTimeFormatterBuilder;
import java.time.format.ResolverStyle;
import java.time.temporal.TemporalAccessor;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.regex.Pattern;

/**
 * Dates with a time as ISO 8601 has them, 2024-06-10T12:00:00.25Z; without a time zone they count
 * as UTC. A space may stand for the T, as many programs write it.
 */
final class Iso8601 {
    private static final Pattern ALIKE =
            Pattern.compile("\\d{4}-\\d{2}-\\d{2}[Tt ]\\d{2}:\\d{2}.*");

    /** A zone is Z, +02:00, +0200 or +02. */
    private static final DateTimeFormatter FORM =
            new DateTimeFormatterBuilder()
                    .append(ISO_LOCAL_DATE)
                    .appendLiteral('T')
                    .append(ISO_LOCAL_TIME)
                    .optionalStart()
                    .appendOffset("+HH:MM", "Z")
                    .optionalEnd()
                    .optionalStart()
                    .appendOffset("+HHMM", "Z")
                    .optionalEnd()
                    .optionalStart()
                    .appendOffset("+HH", "Z")
                    .optionalEnd()
                    .toFormatter(Locale.ROOT)
                    .withResolverStyle(ResolverStyle.STRICT);

    private static final double NANO = 1e-9;

    private Iso8601() {}

    /** Whether a text looks like one. */
    static boolean isLike(String text) {
        return ALIKE.matcher(text).matches();
    }

    /** Seconds since 1970 in UTC; empty if it is none. */
    static OptionalDouble seconds(String text) {
        String usual = text.toUpperCase(Locale.ROOT).replace(' ', 'T').replace(',', '.');
        try {
            TemporalAccessor read =
                    FORM.parseBest(usual, OffsetDateTime::from, LocalDateTime::from);
            Instant at =
                    read instanceof OffsetDateTime zoned
                            ? zoned.toInstant()
                            : LocalDateTime.from(read).toInstant(UTC);
            return OptionalDouble.of(at.getEpochSecond() + NANO * at.getNano());
        } catch (DateTimeException _) {
            return OptionalDouble.empty();
        }
    }
}
