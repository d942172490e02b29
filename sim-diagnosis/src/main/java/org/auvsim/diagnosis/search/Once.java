package org.auvsim.diagnosis.search;

import java.util.Optional;
import java.util.function.Supplier;

/** What is found when it is first asked for, and kept; for one thread. */
final class Once<T> {
    private final Supplier<T> search;
    private Optional<T> found = Optional.empty();

    Once(Supplier<T> search) {
        this.search = search;
    }

    T get() {
        T is = found.orElseGet(search);
        found = Optional.of(is);
        return is;
    }
}
