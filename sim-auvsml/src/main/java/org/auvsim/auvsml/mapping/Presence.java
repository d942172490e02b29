package org.auvsim.auvsml.mapping;

import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.OptionalLong;

/** How many values a record component takes, and what it is without any. */
sealed interface Presence {
    /**
     * The component's value from what was read, where null means nothing; null if it is missing.
     */
    @Nullable Object complete(@Nullable Object read);

    /** What to write of a component's value; null for nothing. */
    default @Nullable Object written(Object value) {
        return value;
    }

    /** Exactly one. */
    record Required() implements Presence {
        @Override
        public @Nullable Object complete(@Nullable Object read) {
            return read;
        }
    }

    /** One, or else this. */
    record Defaulted(Object value) implements Presence {
        @Override
        public Object complete(@Nullable Object read) {
            return read == null ? value : read;
        }
    }

    /** Any number; the values are read into a list. */
    record Many() implements Presence {
        @Override
        public Object complete(@Nullable Object read) {
            return read == null ? List.of() : List.copyOf((List<?>) read);
        }
    }

    /** At most one, in an {@link Optional}. */
    record InOptional() implements Presence {
        @Override
        public Object complete(@Nullable Object read) {
            return Optional.ofNullable(read);
        }

        @Override
        public @Nullable Object written(Object value) {
            Optional<?> optional = (Optional<?>) value;
            return optional.isPresent() ? optional.get() : null;
        }
    }

    /** At most one, in an {@link OptionalDouble}. */
    record InOptionalDouble() implements Presence {
        @Override
        public Object complete(@Nullable Object read) {
            return read == null ? OptionalDouble.empty() : OptionalDouble.of((double) read);
        }

        @Override
        public @Nullable Object written(Object value) {
            OptionalDouble optional = (OptionalDouble) value;
            return optional.isPresent() ? optional.getAsDouble() : null;
        }
    }

    /** At most one, in an {@link OptionalLong}. */
    record InOptionalLong() implements Presence {
        @Override
        public Object complete(@Nullable Object read) {
            return read == null ? OptionalLong.empty() : OptionalLong.of((long) read);
        }

        @Override
        public @Nullable Object written(Object value) {
            OptionalLong optional = (OptionalLong) value;
            return optional.isPresent() ? optional.getAsLong() : null;
        }
    }

    /** At most one, in an {@link OptionalInt}. */
    record InOptionalInt() implements Presence {
        @Override
        public Object complete(@Nullable Object read) {
            return read == null ? OptionalInt.empty() : OptionalInt.of((int) read);
        }

        @Override
        public @Nullable Object written(Object value) {
            OptionalInt optional = (OptionalInt) value;
            return optional.isPresent() ? optional.getAsInt() : null;
        }
    }
}
