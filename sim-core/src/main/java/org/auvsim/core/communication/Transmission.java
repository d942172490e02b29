package org.auvsim.core.communication;

import org.auvsim.core.entity.Change;
import org.auvsim.core.entity.Collidable;
import org.auvsim.core.entity.CollisionResponse;
import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.Contact;
import org.auvsim.core.entity.ExpandingSphere;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Volume;

import java.util.List;
import java.util.Optional;

/**
 * A message on its way (thesis, section 6.3): the front of a wave that grows from the sender's
 * place until it is out of range. It meets each object once that has a transceiver for it, and
 * brings it the message as it touches the object's volume. On whom it is lost, it does not meet.
 *
 * @param sender the transceiver that sent it
 * @param message what it brings
 * @param front how far it is, and whom it has met
 */
public record Transmission(Transceiver sender, TextMessage message, ExpandingSphere front)
        implements Collidable {
    /** Of the front as it begins (m): nothing, as far as messages are concerned. */
    private static final double FIRST_RADIUS = 1e-6;

    /**
     * A message that an object sends now; none if its transceiver does not work where it is.
     *
     * @param kind of the transceiver
     * @param transceiver its name
     * @param id of the entity
     * @param time of the world (s)
     * @throws IllegalArgumentException if the object has no such transceiver
     */
    public static Optional<Transmission> from(
            WorldObject object,
            Class<? extends Transceiver> kind,
            String transceiver,
            String text,
            long id,
            double time) {
        Transceiver sender =
                object.component(kind, transceiver)
                        .map(Transceiver.class::cast)
                        .orElseThrow(() -> missing(object, kind, transceiver));
        return sender.worksAt(placeOf(object, sender))
                ? Optional.of(of(id, object, sender, text, time))
                : Optional.empty();
    }

    private static IllegalArgumentException missing(
            WorldObject object, Class<? extends Transceiver> kind, String name) {
        return new IllegalArgumentException(
                "'%s' has no %s '%s'; it has %s"
                        .formatted(
                                object.name(),
                                kind.getSimpleName(),
                                name,
                                object.components(kind).stream().map(Component::name).toList()));
    }

    private static Transmission of(
            long id, WorldObject object, Transceiver sender, String text, double time) {
        ExpandingSphere front =
                ExpandingSphere.of(
                        id,
                        "message %d of '%s'".formatted(id, object.name()),
                        placeOf(object, sender),
                        time,
                        FIRST_RADIUS,
                        sender.speed(),
                        Math.max(FIRST_RADIUS, sender.range()));
        TextMessage message =
                new TextMessage(object.id(), sender.name(), sender.channel(), time, text);
        return new Transmission(sender, message, front.having(object.id()));
    }

    /** Where an object's transceiver is (m, world). */
    private static Vec3 placeOf(WorldObject object, Transceiver transceiver) {
        return object.position().plus(object.orientation().rotate(transceiver.position()));
    }

    @Override
    public long id() {
        return front.id();
    }

    @Override
    public String name() {
        return front.name();
    }

    @Override
    public Vec3 positionAt(double time) {
        return front.positionAt(time);
    }

    @Override
    public Volume volumeAt(double time) {
        return front.volumeAt(time);
    }

    @Override
    public double fastestSurface(double from, double to) {
        return front.fastestSurface(from, to);
    }

    @Override
    public boolean isOver(double time) {
        return front.isOver(time);
    }

    @Override
    public boolean meets(Collidable other) {
        return front.meets(other) && other instanceof WorldObject object && isHeardBy(object);
    }

    /** Whether any transceiver of an object receives it. */
    private boolean isHeardBy(WorldObject object) {
        for (Transceiver transceiver : object.components(Transceiver.class)) {
            if (transceiver.understands(sender)
                    && transceiver.worksAt(placeOf(object, transceiver))
                    && !transceiver.loses(object.id(), id())) {
                return true;
            }
        }
        return false;
    }

    @Override
    public Optional<CollisionResponse> response() {
        return Optional.of(this::respond);
    }

    private List<Change> respond(Contact contact) {
        long other = contact.other().id();
        return List.of(
                new Change.Update<>(
                        id(),
                        Transmission.class,
                        now -> new Transmission(sender, message, now.front.having(other))),
                new Change.Tell(other, contact.time(), message));
    }
}
