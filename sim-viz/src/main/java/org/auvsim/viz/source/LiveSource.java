package org.auvsim.viz.source;

import static java.util.Objects.requireNonNullElse;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.WorldObjectMessage;
import org.auvsim.auvsml.message.command.ListedClient;
import org.auvsim.auvsml.message.control.GetSimulatorStateRequest;
import org.auvsim.auvsml.message.control.SimulatorStateResponse;
import org.auvsim.auvsml.message.entity.DescribeWorldObjectRequest;
import org.auvsim.auvsml.message.session.ClientListResponse;
import org.auvsim.auvsml.message.session.ListClientsRequest;
import org.auvsim.viz.scene.LiveClock;
import org.auvsim.viz.scene.Occurrence;
import org.auvsim.viz.scene.Scene;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * A simulator that runs, seen by an ordinary client. A thread reads what it tells, another one asks
 * twice a second how it stands; when the connection breaks, it is tried again until it holds.
 */
public final class LiveSource implements Source, Steering {
    private static final long REFRESH_MILLIS = 500;
    private static final long TRY_AGAIN_MILLIS = 2_000;

    /** Who says nothing for so long (s) at the beginning is no simulator. */
    private static final long SILENCE = 30;

    private final String host;
    private final int port;
    private final MessageCatalogue catalogue;
    private final Scene scene = new Scene(new LiveClock());
    private final CountDownLatch closed = new CountDownLatch(1);
    private final CompletableFuture<Void> ready = new CompletableFuture<>();
    private final Pace pace = new Pace();
    private volatile Exchange exchange;
    private volatile Audience audience;
    private volatile Optional<SimulatorStateResponse> state = Optional.empty();
    private volatile List<ListedClient> clients = List.of();
    private volatile Optional<String> trouble = Optional.empty();
    private volatile OptionalLong watched = OptionalLong.empty();

    private LiveSource(String host, int port, MessageCatalogue catalogue, Exchange first) {
        this.host = host;
        this.port = port;
        this.catalogue = catalogue;
        this.exchange = first;
        this.audience = new Audience(scene, first, new Strangers(scene));
    }

    /**
     * Connects to a simulator.
     *
     * @param catalogue the messages that it may send
     * @throws ConnectionException if there is none, or it speaks otherwise
     */
    public static LiveSource connect(String host, int port, MessageCatalogue catalogue)
            throws ConnectionException {
        Exchange first = new Exchange(AuvsmlClient.connect(host, port, catalogue), catalogue);
        LiveSource source = new LiveSource(host, port, catalogue, first);
        Thread.ofVirtual().name("viewer reads").start(source::stayConnected);
        Thread.ofVirtual().name("viewer asks").start(source::keepAsking);
        return source;
    }

    private void stayConnected() {
        while (!isClosed()) {
            attend(exchange);
            reconnect();
        }
    }

    private void attend(Exchange to) {
        scene.clear();
        trouble = Optional.empty();
        SceneWriter writer = new SceneWriter(scene);
        Strangers strangers = new Strangers(scene);
        Audience asking = new Audience(scene, to, strangers);
        audience = asking;
        Thread.startVirtualThread(() -> begin(asking, to));
        String why =
                to.read(
                        letter -> {
                            strangers.hear(letter);
                            letter.messages().forEach(message -> hear(message, writer, asking));
                            if (letter.requestId().isEmpty()) {
                                writer.tellFaults(letter.messages());
                            }
                        });
        to.close();
        state = Optional.empty();
        clients = List.of();
        pace.forget();
        ready.completeExceptionally(new RefusedException(why));
        say(why);
    }

    private void hear(Message message, SceneWriter writer, Audience asking) {
        writer.write(message);
        asking.hear(message);
        if (message instanceof SimulatorStateResponse now) {
            state = Optional.of(now);
            pace.hear(now, System.nanoTime());
        }
        if (message instanceof ClientListResponse(List<ListedClient> now)) {
            clients = now;
        }
    }

    /** A simulator that does not tell what there is is left; another try may find another one. */
    private void begin(Audience asking, Exchange to) {
        try {
            asking.begin();
            ready.complete(null);
        } catch (CompletionException e) {
            String why = String.valueOf(requireNonNullElse(e.getCause(), e).getMessage());
            say(why);
            ready.completeExceptionally(new RefusedException(why));
            to.close();
        }
    }

    private void say(String why) {
        if (!isClosed() && !trouble.equals(Optional.of(why))) {
            trouble = Optional.of(why);
            scene.tell(new Occurrence(scene.time(), why));
        }
    }

    private void reconnect() {
        while (!isClosed() && !waits(TRY_AGAIN_MILLIS)) {
            try {
                Exchange next =
                        new Exchange(AuvsmlClient.connect(host, port, catalogue), catalogue);
                scene.tell(new Occurrence(scene.time(), "Connected again."));
                exchange = next;
                if (isClosed()) {
                    next.close();
                }
                return;
            } catch (ConnectionException e) {
                say(String.valueOf(e.getMessage()));
            }
        }
    }

    private void keepAsking() {
        while (!waits(REFRESH_MILLIS)) {
            if (isConnected()) {
                exchange.want(new GetSimulatorStateRequest());
                exchange.want(new ListClientsRequest());
                audience.refresh(watched);
            }
        }
    }

    /** Waits; whether the source was closed meanwhile. */
    private boolean waits(long millis) {
        try {
            return closed.await(millis, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return true;
        }
    }

    private boolean isClosed() {
        return closed.getCount() == 0;
    }

    @Override
    public Scene scene() {
        return scene;
    }

    /** Fails with a {@link RefusedException} if the simulator goes or is silent. */
    @Override
    public CompletableFuture<Void> ready() {
        return ready.copy()
                .orTimeout(SILENCE, TimeUnit.SECONDS)
                .exceptionallyCompose(
                        failure ->
                                CompletableFuture.failedFuture(
                                        failure instanceof TimeoutException
                                                ? new RefusedException(
                                                        "The simulator at %s:%d has not told within %d s what there is."
                                                                .formatted(host, port, SILENCE))
                                                : failure));
    }

    @Override
    public void bring(long nanos) {
        // What comes is written when it comes.
    }

    @Override
    public String status() {
        if (trouble.isPresent()) {
            return trouble.get() + " Trying again ...";
        }
        String place =
                "%s:%d, %s, as %s"
                        .formatted(
                                host,
                                port,
                                exchange.client().welcome().server(),
                                role().roleName());
        return state.map(
                        now ->
                                String.format(
                                        Locale.ROOT,
                                        "%s: %.2f s, %s",
                                        place,
                                        now.time(),
                                        now.running() ? rate(now) : "paused"))
                .orElse(place);
    }

    /** The rate that is wished, and the one that is reached. */
    private String rate(SimulatorStateResponse now) {
        OptionalDouble reached = pace.reached();
        return "rate "
                + now.rate()
                + (reached.isEmpty()
                        ? ""
                        : String.format(Locale.ROOT, " (reached %.2f)", reached.getAsDouble()));
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
    public Role role() {
        return isConnected()
                ? Role.named(exchange.client().welcome().role()).orElse(Role.VIEWER)
                : Role.VIEWER;
    }

    @Override
    public boolean isConnected() {
        return trouble.isEmpty() && !isClosed();
    }

    @Override
    public Optional<SimulatorStateResponse> state() {
        return state;
    }

    @Override
    public List<ListedClient> clients() {
        return clients;
    }

    @Override
    public long session() {
        return exchange.client().welcome().sessionId();
    }

    /** What was done to an object is asked for at once, so that it is seen. */
    @Override
    public CompletableFuture<Message> ask(Message message) {
        Exchange to = exchange;
        CompletableFuture<Message> answer = to.post(message);
        if (message instanceof WorldObjectMessage about
                && !(message instanceof DescribeWorldObjectRequest)) {
            Message again = new DescribeWorldObjectRequest(about.worldObjectId());
            return answer.whenComplete((_, _) -> Thread.startVirtualThread(() -> to.want(again)));
        }
        return answer;
    }

    @Override
    public void watch(OptionalLong id) {
        watched = id;
    }

    @Override
    public void close() {
        closed.countDown();
        exchange.close();
        ready.completeExceptionally(new RefusedException("The viewer was closed."));
    }
}
