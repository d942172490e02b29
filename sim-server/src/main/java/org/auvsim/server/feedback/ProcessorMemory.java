package org.auvsim.server.feedback;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * What feedback processors remember of the objects that they correct, from one correction to the
 * next: an immutable value for each object and processor. It belongs to a simulation's state as the
 * world does: a copy of one goes with a copy of the other.
 */
public final class ProcessorMemory {
    private record Key(long objectId, String processor) {}

    private final Map<Key, Object> values = new HashMap<>();

    /** Nothing yet. */
    public ProcessorMemory() {}

    /** A memory of its own with the same values. */
    public ProcessorMemory copy() {
        ProcessorMemory copy = new ProcessorMemory();
        copy.values.putAll(values);
        return copy;
    }

    /** Takes over the values of another one in place of its own. */
    public void restore(ProcessorMemory snapshot) {
        Map<Key, Object> restored = Map.copyOf(snapshot.values);
        values.clear();
        values.putAll(restored);
    }

    /** What a processor remembers of an object, if it is of this type. */
    <M> Optional<M> recall(long objectId, String processor, Class<M> type) {
        return Optional.ofNullable(values.get(new Key(objectId, processor)))
                .filter(type::isInstance)
                .map(type::cast);
    }

    void remember(long objectId, String processor, Object value) {
        values.put(new Key(objectId, processor), value);
    }
}
