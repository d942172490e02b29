package org.auvsim.server.net;

import org.auvsim.auvsml.message.command.EventType;
import org.auvsim.auvsml.message.command.ListenedObject;
import org.auvsim.auvsml.message.command.Listener;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;

/** What one client wants to hear, by object and type of event. Belongs to the simulation thread. */
final class Registrations {
    /** Stands for every object, present and future. */
    private static final long EVERY = Topic.NOBODY;

    /** The types whose messages a maximal rate thins. */
    private static final Set<EventType> THINNED =
            EnumSet.of(
                    EventType.MOVEMENT_STATE_CHANGE,
                    EventType.PROJECTED_MOVEMENT,
                    EventType.KINEMATIC_STATE);

    /** The types that belong to no object: whoever listens to them for one hears of them. */
    private static final Set<EventType> OF_THE_STEP =
            EnumSet.of(EventType.TIMESTEP_ADVANCED, EventType.STEP_REPORT);

    /** So much earlier (s) than its time a movement may come: world times are rounded sums. */
    private static final double ROUNDING = 1e-9;

    private final Map<Long, Map<EventType, OptionalDouble>> shortestGaps = new HashMap<>();
    private final Map<Topic, Double> lastSent = new HashMap<>();

    /** Begins to listen; a type that is listened to already takes the new rate. */
    void register(ListenedObject object) {
        Map<EventType, OptionalDouble> types =
                shortestGaps.computeIfAbsent(key(object), _ -> new EnumMap<>(EventType.class));
        for (Listener listener : object.listener()) {
            OptionalDouble gap =
                    listener.maxRate().isPresent()
                            ? OptionalDouble.of(1 / listener.maxRate().getAsDouble())
                            : OptionalDouble.empty();
            types(listener).forEach(type -> types.put(type, gap));
        }
    }

    /** Ends to listen; what is not listened to stays so. */
    void unregister(ListenedObject object) {
        Map<EventType, OptionalDouble> types = shortestGaps.getOrDefault(key(object), Map.of());
        for (Listener listener : object.listener()) {
            types.keySet().removeAll(types(listener));
        }
        if (types.isEmpty()) {
            shortestGaps.remove(key(object));
        }
    }

    /** Whether anything of this object by itself, not of all, is listened to. */
    boolean names(long objectId) {
        return shortestGaps.containsKey(objectId);
    }

    private static long key(ListenedObject object) {
        return object.worldObjectId().orElse(EVERY);
    }

    private static Set<EventType> types(Listener listener) {
        return listener.type().equals(Listener.ALL)
                ? EnumSet.allOf(EventType.class)
                : EnumSet.of(EventType.named(listener.type()).orElseThrow());
    }

    /**
     * Whether the client is to hear of something at a world time (s); if it is, the time counts as
     * that of its last message on this topic.
     */
    boolean wants(Topic topic, double time) {
        if (OF_THE_STEP.contains(topic.type())) {
            return shortestGaps.values().stream().anyMatch(t -> t.containsKey(topic.type()));
        }
        return wants(EVERY, topic, time) || wants(topic.about(), topic, time);
    }

    private boolean wants(long object, Topic topic, double time) {
        OptionalDouble gap = shortestGaps.getOrDefault(object, Map.of()).get(topic.type());
        if (gap == null) {
            return false;
        }
        if (gap.isEmpty() || !THINNED.contains(topic.type())) {
            return true;
        }
        double last = lastSent.getOrDefault(topic, Double.NEGATIVE_INFINITY);
        // The same time again is the same movement, corrected; an earlier one, a time gone back to.
        boolean due = time <= last || time - last >= gap.getAsDouble() - ROUNDING;
        if (due) {
            lastSent.put(topic, time);
        }
        return due;
    }
}
