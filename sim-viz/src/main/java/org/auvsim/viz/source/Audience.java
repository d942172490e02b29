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
import org.auvsim.viz.scene.Occurrence;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;
import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;

/** What a viewer asks for: what there is, how it moves, and now and then what is done to it. */
final class Audience {
    /** More movements a second of world time are no smoother to the eye. */
    private static final double MOST_A_SECOND = 30;

    /** While more questions than this wait for their answers no object is asked about again. */
    private static final int MOST_UNANSWERED = 20;

    /** In a world of more objects projected states are left out. */
    static final int MOST_PROJECTED = 200;

    private static final List<EventType> EVENTS =
            List.of(
                    EventType.KINEMATIC_STATE,
                    EventType.PROJECTED_MOVEMENT,
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
    private final Turns turns = new Turns();
    private volatile boolean hasBegun;
    private boolean isProjected = true;

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
        survey();
        exchange.ask(registration(/* on= */ true, EVENTS))
                .handle((_, refusal) -> told(refusal))
                .join();
        hasBegun = true;
        fitProjected();
    }

    /** In a large world projected states are left out: they would double what is sent. */
    private synchronized void fitProjected() {
        int count = scene.objects().size();
        boolean fits = count <= MOST_PROJECTED;
        if (fits != isProjected) {
            isProjected = fits;
            tell(projectedWords(count));
            exchange.want(registration(fits, List.of(EventType.PROJECTED_MOVEMENT)));
        }
    }

    /** What becomes of projected states in a world of so many objects. */
    static String projectedWords(int count) {
        if (count == 1) {
            return "There is 1 object: its projected state is shown again";
        }
        return "There are %d objects: their projected states are %s"
                .formatted(count, count <= MOST_PROJECTED ? "shown again" : "left out");
    }

    /** Asks what there is. */
    private void survey() {
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
        scene.enterWorld();
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

    private static Message registration(boolean on, List<EventType> types) {
        List<Listener> listeners =
                types.stream()
                        .map(t -> new Listener(t.eventName(), OptionalDouble.of(MOST_A_SECOND)))
                        .toList();
        return new ListenerRegistrationRequestCommand(
                on, List.of(new ListenedObject(ListenedObject.EVERY, listeners)));
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
            case SnapshotRestoredNotification _ -> {
                scene.leaveWorld();
                Thread.startVirtualThread(this::surveyAgain);
            }
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

    /** Once all is known, asks again about some objects, and for as much as their number lets. */
    void refresh(OptionalLong watched) {
        if (!hasBegun) {
            return;
        }
        fitProjected();
        if (exchange.unanswered() <= MOST_UNANSWERED) {
            turns.next(scene.objects(), watched)
                    .forEach(id -> exchange.want(new DescribeWorldObjectRequest(id)));
        }
    }
}
