package org.auvsim.cli.export;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/** The cells of a row, in the order of its table's columns: numbers, texts, or nothing. */
final class Row {
    private final List<Optional<Object>> cells = new ArrayList<>();

    Row add(long number) {
        return cell(number);
    }

    Row add(double number) {
        return cell(number);
    }

    Row add(boolean flag) {
        return cell(flag ? 1L : 0L);
    }

    Row add(String text) {
        return cell(text);
    }

    Row add(Vec3 v) {
        return add(v.x()).add(v.y()).add(v.z());
    }

    Row add(Quat q) {
        return add(q.w()).add(q.x()).add(q.y()).add(q.z());
    }

    Row vector(Optional<Vec3> v) {
        return v.map(this::add).orElseGet(() -> nothing(3));
    }

    Row orientation(Optional<Quat> q) {
        return q.map(this::add).orElseGet(() -> nothing(4));
    }

    Row text(Optional<String> text) {
        return text.map(this::add).orElseGet(() -> nothing(1));
    }

    private Row nothing(int count) {
        cells.addAll(Collections.nCopies(count, Optional.empty()));
        return this;
    }

    private Row cell(Object value) {
        cells.add(Optional.of(value));
        return this;
    }

    List<Optional<Object>> cells() {
        return cells;
    }
}
