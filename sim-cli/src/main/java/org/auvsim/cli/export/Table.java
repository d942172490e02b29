package org.auvsim.cli.export;

import static org.auvsim.cli.export.Column.integer;
import static org.auvsim.cli.export.Column.real;
import static org.auvsim.cli.export.Column.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/** The tables that a recording becomes; seconds, metres, kilograms, radians, world axes. */
public enum Table {
    /** A row for each movement: position, orientation (body to world), momenta. */
    MOVEMENTS,
    /** A row for each collision: place, normal out of the other one, impulse on the first. */
    COLLISIONS,
    /** A row for each feedback; what was not measured is empty. */
    FEEDBACK,
    /** A row for each message that clients sent, feedback too, as it was on the wire. */
    MESSAGES,
    /** A row for each client that came or went. */
    SESSIONS;

    /** Its name in a database, and of its file. */
    public String sqlName() {
        return name().toLowerCase(Locale.ROOT);
    }

    List<Column> columns() {
        return switch (this) {
            case MOVEMENTS ->
                    joined(moment(), body(""), vector(""), orientation(), vector("p"), vector("l"));
            case COLLISIONS ->
                    joined(
                            moment(),
                            body(""),
                            body("other_"),
                            vector(""),
                            vector("normal_"),
                            vector("impulse_"));
            case FEEDBACK ->
                    joined(
                            place(),
                            body(""),
                            List.of(text("kind"), real("measured_at")),
                            List.of(text("handler"), text("frame")),
                            vector(""),
                            orientation(),
                            vector("v"),
                            vector("w"));
            case MESSAGES ->
                    joined(place(), List.of(text("request_id"), text("kind"), text("auvsml")));
            case SESSIONS -> joined(place(), List.of(text("event"), text("peer"), text("role")));
        };
    }

    @SafeVarargs
    private static List<Column> joined(List<Column>... parts) {
        List<Column> all = new ArrayList<>();
        for (List<Column> part : parts) {
            all.addAll(part);
        }
        return all;
    }

    /** After which step something was so; a step may be made again as history is revised. */
    private static List<Column> moment() {
        return List.of(integer("revision"), integer("step"), real("t"));
    }

    /** Where among the inputs something came. */
    private static List<Column> place() {
        return List.of(
                integer("step"),
                integer("input"),
                integer("during_step"),
                real("t"),
                integer("session"));
    }

    private static List<Column> body(String prefix) {
        return List.of(integer(prefix + "id"), text(prefix + "name"));
    }

    private static List<Column> vector(String prefix) {
        return reals(prefix + "x", prefix + "y", prefix + "z");
    }

    private static List<Column> orientation() {
        return reals("qw", "qx", "qy", "qz");
    }

    private static List<Column> reals(String... names) {
        return Stream.of(names).map(Column::real).toList();
    }
}
