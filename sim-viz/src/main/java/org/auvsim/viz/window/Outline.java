package org.auvsim.viz.window;

import org.auvsim.viz.scene.SeenObject;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Objects as a tree, by kinds and with their parts; what is folded or filtered out is not in it.
 */
final class Outline {
    private final Set<Kind> folded = EnumSet.noneOf(Kind.class);
    private final Set<Long> opened = new HashSet<>();
    private Optional<Comparator<SeenObject>> order = Optional.empty();
    private String wanted = "";

    /** Objects of each kind stand in this order; empty: that of their coming. */
    void sort(Optional<Comparator<SeenObject>> by) {
        order = by;
    }

    /** Only objects whose name contains this, or whose id it is, are wanted. */
    void filter(String words) {
        wanted = words.strip().toLowerCase(Locale.ROOT);
    }

    boolean isOpen(Row row) {
        return switch (row) {
            case Row.Group group -> !folded.contains(group.kind());
            case Row.Item item -> opened.contains(item.object().id());
            case Row.Part _ -> false;
        };
    }

    void open(Row row, boolean on) {
        switch (row) {
            case Row.Group group -> {
                if (on) {
                    folded.remove(group.kind());
                } else {
                    folded.add(group.kind());
                }
            }
            case Row.Item item -> {
                if (on) {
                    opened.add(item.object().id());
                } else {
                    opened.remove(item.object().id());
                }
            }
            case Row.Part _ -> {}
        }
    }

    /** Unfolds what an object is in; whether it was folded. */
    boolean reveal(SeenObject object) {
        return folded.remove(Kind.of(object));
    }

    List<Row> rows(List<SeenObject> objects) {
        Map<Kind, List<SeenObject>> kinds = new EnumMap<>(Kind.class);
        for (SeenObject object : objects) {
            if (isWanted(object)) {
                kinds.computeIfAbsent(Kind.of(object), kind -> new ArrayList<>()).add(object);
            }
        }
        List<Row> rows = new ArrayList<>();
        kinds.forEach(
                (kind, members) -> {
                    Row group = new Row.Group(kind, members.size());
                    rows.add(group);
                    if (isOpen(group)) {
                        order.ifPresent(members::sort);
                        members.forEach(member -> add(member, rows));
                    }
                });
        return rows;
    }

    private boolean isWanted(SeenObject object) {
        return object.name().toLowerCase(Locale.ROOT).contains(wanted)
                || Long.toString(object.id()).equals(wanted);
    }

    private void add(SeenObject object, List<Row> rows) {
        Row item = new Row.Item(object);
        rows.add(item);
        if (isOpen(item)) {
            object.definition()
                    .ifPresent(d -> d.component().forEach(c -> rows.add(new Row.Part(object, c))));
        }
    }
}
