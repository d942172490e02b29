package org.auvsim.viz.source;

import static java.util.stream.Collectors.toSet;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.EventType;
import org.auvsim.auvsml.message.command.ListedWorldObject;
import org.auvsim.auvsml.message.command.ListenedObject;
import org.auvsim.auvsml.message.command.Listener;
import org.auvsim.auvsml.message.control.SnapshotRestoredNotification;
import org.auvsim.auvsml.message.entity.DescribeWorldObjectRequest;
import org.auvsim.auvsml.message.entity.EntityAddedMessage;
import org.auvsim.auvsml.message.entity.EntityRemovedMessage;
import org.auvsim.auvsml.message.entity.GetFieldListRequest;
import org.auvsim.auvsml.message.entity.GetWorldObjectListCommand;
import org.auvsim.auvsml.message.entity.WorldObjectListResponse;
import org.auvsim.auvsml.message.listening.ListenerRegistrationRequestCommand;
import org.auvsim.core.actuator.Fin;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.viz.scene.Occurrence;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;
import org.jspecify.annotations.Nullable;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.stream.Stream;

/** What a viewer asks for: what there is, how it moves, and now and then what is done to it. */
final class Audience {
    /** More movements a second of world time are no smoother to the eye. */
    private static final double MOST_A_SECOND = 30;

    /** In a larger world projected states are left out: they would double what is sent. */
    private static final int MOST_PROJECTED = 200;

    /** So many objects' forces and propulsors are asked for at a time. */
    private static final int MOST_WATCHED = 20;

    private static final List<EventType> EVENTS =
            List.of(
                    EventType.KINEMATIC_STATE,
                    EventType.TIMESTEP_ADVANCED,
                    EventType.COLLISION,
                    EventType.RADIO,
                    EventType.ENTITY_ADDED,
                    EventType.ENTITY_REMOVED,
                    EventType.FEEDBACK_APPLIED,
                    EventType.MODEL_CORRECTION);

    private final Scene scene;
    private final Exchange exchange;
    private final Strangers strangers;
    private int turn;

    Audience(Scene scene, Exchange exchange, Strangers strangers) {
        this.scene = scene;
        this.exchange = exchange;
        this.strangers = strangers;
    }

    /**
     * Asks for everything, registers, and waits for the answers, which come while the exchange is
     * read by another thread; then the scene has all objects and hears how they move.
     */
    void begin() {
        int count = survey();
        boolean projected = count <= MOST_PROJECTED;
        if (!projected) {
            tell("There are %d objects: their projected states are left out".formatted(count));
        }
        exchange.ask(registration(projected)).handle((_, refusal) -> told(refusal)).join();
    }

    /** Asks what there is; the number of objects. */
    private int survey() {
        CompletableFuture<Message> fields = exchange.ask(new GetFieldListRequest());
        Message answer = exchange.ask(new GetWorldObjectListCommand()).join();
        List<ListedWorldObject> objects =
                answer instanceof WorldObjectListResponse(List<ListedWorldObject> all)
                        ? all
                        : List.of();
        scene.keepOnly(objects.stream().map(ListedWorldObject::id).collect(toSet()));
        CompletableFuture.allOf(
                        objects.stream()
                                .map(o -> describe(o.id(), o.name()))
                                .toArray(CompletableFuture[]::new))
                .join();
        fields.handle((_, refusal) -> told(refusal)).join();
        return objects.size();
    }

    private void tell(String sentence) {
        scene.tell(new Occurrence(scene.time(), sentence));
    }

    private boolean told(@Nullable Throwable refusal) {
        if (refusal != null) {
            tell(String.valueOf(refusal.getMessage()));
        }
        return refusal == null;
    }

    private static Message registration(boolean projected) {
        List<EventType> types =
                projected
                        ? Stream.concat(EVENTS.stream(), Stream.of(EventType.PROJECTED_MOVEMENT))
                                .toList()
                        : EVENTS;
        List<Listener> listeners =
                types.stream()
                        .map(t -> new Listener(t.eventName(), OptionalDouble.of(MOST_A_SECOND)))
                        .toList();
        return new ListenerRegistrationRequestCommand(
                true, List.of(new ListenedObject(ListenedObject.EVERY, listeners)));
    }

    /** Asks what an object is made of; if that cannot be read, its name is all that is known. */
    private CompletableFuture<Boolean> describe(long id, String name) {
        return exchange.ask(new DescribeWorldObjectRequest(id))
                .handle(
                        (_, refusal) -> {
                            if (refusal instanceof UnknownException unknown) {
                                scene.add(new SeenObject(id, name, Optional.empty()));
                                strangers.tell(
                                        name,
                                        "has %s, without which this viewer shows it as a small box"
                                                .formatted(unknown.words()));
                            }
                            return refusal == null;
                        });
    }

    /** Asks about what has come, and for everything where time has gone elsewhere. */
    void hear(Message message) {
        switch (message) {
            case EntityAddedMessage(double _, long id) ->
                    Thread.startVirtualThread(
                            () -> {
                                var _ = describe(id, "#" + id);
                                exchange.want(new GetFieldListRequest());
                            });
            case EntityRemovedMessage _ ->
                    Thread.startVirtualThread(() -> exchange.want(new GetFieldListRequest()));
            case SnapshotRestoredNotification _ -> Thread.startVirtualThread(this::surveyAgain);
            default -> {}
        }
    }

    private void surveyAgain() {
        try {
            survey();
        } catch (CompletionException _) {
            // The connection has ended: whoever reads it tells so.
        }
    }

    /** Asks again about some that something is done to, and about some others in turn. */
    void refresh() {
        if (exchange.unanswered() > MOST_WATCHED) {
            return;
        }
        List<SeenObject> moving = scene.objects().stream().filter(o -> !o.isFixed()).toList();
        LinkedHashSet<Long> ids = new LinkedHashSet<>();
        moving.stream()
                .filter(o -> o.definition().filter(Audience::isDriven).isPresent())
                .limit(MOST_WATCHED / 2)
                .forEach(o -> ids.add(o.id()));
        for (int i = 0; i < moving.size() && ids.size() < MOST_WATCHED; i++) {
            turn = (turn + 1) % moving.size();
            ids.add(moving.get(turn).id());
        }
        ids.forEach(id -> exchange.want(new DescribeWorldObjectRequest(id)));
    }

    private static boolean isDriven(WorldObjectDefinition definition) {
        return !definition.force().isEmpty()
                || definition.component().stream()
                        .anyMatch(c -> c instanceof Propulsor || c instanceof Fin);
    }
}
