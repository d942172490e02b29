package org.auvsim.viz.window;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.KeptSnapshot;
import org.auvsim.auvsml.message.command.ListedClient;
import org.auvsim.auvsml.message.control.ListSnapshotsRequest;
import org.auvsim.auvsml.message.control.SimulatorStateResponse;
import org.auvsim.auvsml.message.control.SnapshotListResponse;
import org.auvsim.auvsml.message.session.ClientListResponse;
import org.auvsim.auvsml.message.session.CommandDoneResponse;
import org.auvsim.auvsml.message.session.ListClientsRequest;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.source.LostException;
import org.auvsim.viz.source.Playback;
import org.auvsim.viz.source.Source;
import org.auvsim.viz.source.Steering;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Predicate;

/** A simulator that remembers what it is asked for. */
final class FakeSimulator implements Source, Steering {
    private static final long OURS = 3;
    final List<Message> asked = new CopyOnWriteArrayList<>();
    private final Scene scene;
    volatile Role role = Role.ADMIN;
    volatile boolean isConnected = true;
    volatile boolean isRunning = true;
    volatile Optional<String> refusal = Optional.empty();
    volatile Predicate<Message> loses = _ -> false;
    volatile Predicate<Message> refuses = _ -> false;
    volatile List<ListedClient> clients = List.of();
    volatile OptionalLong watched = OptionalLong.empty();

    FakeSimulator(Scene scene) {
        this.scene = scene;
    }

    @Override
    public Scene scene() {
        return scene;
    }

    @Override
    public void bring(long nanos) {}

    @Override
    public String status() {
        return isConnected
                ? "127.0.0.1:40001, 12.50 s, running"
                : "The connection to 127.0.0.1:40001 is lost; trying again.";
    }

    @Override
    public Optional<Steering> steering() {
        return Optional.of(this);
    }

    @Override
    public Optional<Playback> playback() {
        return Optional.empty();
    }

    @Override
    public void close() {}

    @Override
    public Role role() {
        return role;
    }

    @Override
    public boolean isConnected() {
        return isConnected;
    }

    @Override
    public Optional<SimulatorStateResponse> state() {
        return Optional.of(new SimulatorStateResponse(12.5, isRunning, "1.0", 625, 2));
    }

    @Override
    public List<ListedClient> clients() {
        return clients;
    }

    @Override
    public long session() {
        return OURS;
    }

    /** Fails as a live source does: by a stage after the one that failed. */
    @Override
    public CompletableFuture<Message> ask(Message message) {
        asked.add(message);
        return failure(message)
                .<CompletableFuture<Message>>map(CompletableFuture::failedFuture)
                .orElseGet(() -> CompletableFuture.completedFuture(answer(message)))
                .whenComplete((_, _) -> {});
    }

    private Optional<Exception> failure(Message message) {
        if (loses.test(message)) {
            return Optional.of(new LostException("The connection is lost."));
        }
        return refuses.test(message)
                ? Optional.of(new IllegalStateException("Not this."))
                : refusal.map(IllegalStateException::new);
    }

    @Override
    public void watch(OptionalLong id) {
        watched = id;
    }

    private static Message answer(Message message) {
        return switch (message) {
            case ListSnapshotsRequest _ ->
                    new SnapshotListResponse(List.of(new KeptSnapshot("before", 3)));
            case ListClientsRequest _ ->
                    new ClientListResponse(
                            List.of(
                                    new ListedClient(
                                            4,
                                            "Vehicle",
                                            "127.0.0.1:5",
                                            "controller",
                                            false,
                                            List.of()),
                                    new ListedClient(
                                            OURS,
                                            "Viewer",
                                            "127.0.0.1:6",
                                            "admin",
                                            false,
                                            List.of())));
            default -> new CommandDoneResponse();
        };
    }
}
