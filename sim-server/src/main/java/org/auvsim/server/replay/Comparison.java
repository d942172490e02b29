package org.auvsim.server.replay;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.movement.CollisionNotification;
import org.auvsim.auvsml.message.movement.MovementStateChangeMessage;
import org.auvsim.auvsml.recording.Entry;
import org.auvsim.auvsml.recording.Happened;
import org.auvsim.auvsml.recording.StateHash;
import org.auvsim.core.description.ElementName;
import org.auvsim.core.world.World;

import java.util.List;
import java.util.Optional;

/** Holds what a replay brings against what the recording tells, and keeps the first difference. */
final class Comparison {
    private static final String NOTHING = "nothing";

    private final World world;
    private Optional<Divergence> divergence = Optional.empty();
    private long hashes;

    /** Objects are named as in {@code world}. */
    Comparison(World world) {
        this.world = world;
    }

    /** Where the two first differ. */
    Optional<Divergence> divergence() {
        return divergence;
    }

    /** Number of hashes that were equal. */
    long hashes() {
        return hashes;
    }

    /** Compares two entries that stand at the same place. */
    void compare(Entry recorded, Entry replayed) {
        if (recorded.equals(replayed)) {
            hashes += recorded instanceof StateHash ? 1 : 0;
        } else if (recorded instanceof StateHash was && replayed instanceof StateHash is) {
            FirstDifference hash = new FirstDifference("the state's hash", was.hash(), is.hash());
            differ(replayed, Optional.empty(), hash);
        } else {
            differ(replayed, messages(recorded), messages(replayed));
        }
    }

    /** The replay has nothing where the recording has this. */
    void missing(Entry recorded) {
        differ(recorded, messages(recorded), List.of());
    }

    /** The recording has nothing where the replay has this. */
    void surplus(Entry replayed) {
        differ(replayed, List.of(), messages(replayed));
    }

    /** The two differ in something that is no entry. */
    void differ(Entry place, FirstDifference how) {
        differ(place, Optional.empty(), how);
    }

    private static List<Message> messages(Entry entry) {
        return entry instanceof Happened happened ? happened.message() : List.of();
    }

    private void differ(Entry place, List<Message> recorded, List<Message> replayed) {
        int i = 0;
        while (i < Math.min(recorded.size(), replayed.size())
                && recorded.get(i).equals(replayed.get(i))) {
            i++;
        }
        Optional<Message> was = recorded.stream().skip(i).findFirst();
        Optional<Message> is = replayed.stream().skip(i).findFirst();
        Optional<Long> object = was.or(() -> is).flatMap(Comparison::objectOf);
        boolean areAlike =
                was.map(Object::getClass).equals(is.map(Object::getClass))
                        && was.flatMap(Comparison::objectOf)
                                .equals(is.flatMap(Comparison::objectOf))
                        && was.isPresent();
        FirstDifference how =
                areAlike
                        ? FirstDifference.between(was.orElseThrow(), is.orElseThrow()).orElseThrow()
                        : new FirstDifference("what happened", what(was), what(is));
        differ(place, object, how);
    }

    private void differ(Entry place, Optional<Long> object, FirstDifference how) {
        if (divergence.isEmpty()) {
            divergence =
                    Optional.of(
                            new Divergence(
                                    place.step(),
                                    place.timestamp(),
                                    object.map(this::name),
                                    how.path(),
                                    how.recorded(),
                                    how.replayed()));
        }
    }

    private static Optional<Long> objectOf(Message message) {
        return switch (message) {
            case MovementStateChangeMessage moved -> Optional.of(moved.worldObjectId());
            case CollisionNotification met -> Optional.of(met.entityId());
            default -> Optional.empty();
        };
    }

    private String what(Optional<Message> message) {
        return message.map(
                        m ->
                                ElementName.of(m.getClass())
                                        + objectOf(m).map(id -> " of " + name(id)).orElse(""))
                .orElse(NOTHING);
    }

    private String name(long id) {
        return world.objects().stream()
                .filter(object -> object.id() == id)
                .findFirst()
                .map(object -> "'%s' (id %d)".formatted(object.name(), id))
                .orElseGet(() -> "id " + id);
    }
}
