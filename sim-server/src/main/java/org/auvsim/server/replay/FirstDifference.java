package org.auvsim.server.replay;

import java.lang.reflect.RecordComponent;
import java.util.List;
import java.util.Optional;

/**
 * The first single value in which two of the same kind differ.
 *
 * @param path to it, as {@code position.x}
 */
record FirstDifference(String path, String recorded, String replayed) {
    private static final String NOTHING = "nothing";

    /** That of two values; empty if they are equal, numbers to the bit. */
    static Optional<FirstDifference> between(Object recorded, Object replayed) {
        return between("", recorded, replayed);
    }

    private static Optional<FirstDifference> between(
            String path, Object recorded, Object replayed) {
        if (recorded.equals(replayed)) {
            return Optional.empty();
        }
        if (recorded instanceof List<?> ours && replayed instanceof List<?> theirs) {
            return ofLists(path, ours, theirs);
        }
        if (recorded instanceof Record ours && recorded.getClass() == replayed.getClass()) {
            return ofRecords(path, ours, (Record) replayed);
        }
        return Optional.of(
                new FirstDifference(path, String.valueOf(recorded), String.valueOf(replayed)));
    }

    private static Optional<FirstDifference> ofLists(String path, List<?> ours, List<?> theirs) {
        int shared = Math.min(ours.size(), theirs.size());
        for (int i = 0; i < shared; i++) {
            Optional<FirstDifference> found =
                    between("%s[%d]".formatted(path, i), ours.get(i), theirs.get(i));
            if (found.isPresent()) {
                return found;
            }
        }
        return Optional.of(
                new FirstDifference(
                        "%s[%d]".formatted(path, shared),
                        ours.size() > shared ? String.valueOf(ours.get(shared)) : NOTHING,
                        theirs.size() > shared ? String.valueOf(theirs.get(shared)) : NOTHING));
    }

    private static Optional<FirstDifference> ofRecords(String path, Record ours, Record theirs) {
        for (RecordComponent component : ours.getClass().getRecordComponents()) {
            String inner = path.isEmpty() ? component.getName() : path + "." + component.getName();
            Optional<FirstDifference> found =
                    between(inner, value(component, ours), value(component, theirs));
            if (found.isPresent()) {
                return found;
            }
        }
        return Optional.empty();
    }

    private static Object value(RecordComponent component, Record record) {
        try {
            component.getAccessor().setAccessible(true);
            return component.getAccessor().invoke(record);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(component + " cannot be read", e);
        }
    }
}
