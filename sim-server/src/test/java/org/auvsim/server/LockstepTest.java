package org.auvsim.server;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.document.WhenLate;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.auvsim.server.feedback.LockstepTimestepper;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.function.Function;

/** Clients and simulator keep step, over real sockets. */
@Timeout(60)
class LockstepTest {
    private static final String LISTEN =
            "<listener-registration-request-command register=\"1\"><world-object id=\"1\">"
                    + "<listener type=\"TimestepAdvanced\"/></world-object>"
                    + "</listener-registration-request-command>";

    private final TcpTransport tcp = TcpTransport.onLoopback(0);
    private final List<RawClient> clients = new ArrayList<>();
    private Optional<Simulator> simulator = Optional.empty();

    private Simulator start(LockstepTimestepper timestepper) {
        Simulator started =
                Simulator.of(Tank.world())
                        .timestepper(timestepper)
                        .rate(OptionalDouble.empty())
                        .paused()
                        .transport(tcp)
                        .start();
        simulator = Optional.of(started);
        return started;
    }

    @AfterEach
    void close() throws IOException {
        for (RawClient client : clients) {
            client.close();
        }
        simulator.ifPresent(Simulator::close);
    }

    private RawClient member(String name) throws IOException {
        RawClient client = RawClient.welcomed(tcp.port());
        clients.add(client);
        client.ask("l", LISTEN);
        assertThat(client.ask("h", "<hello-command name=\"" + name + "\"/>"))
                .contains("<hello-response");
        return client;
    }

    /** Waits for the next step that is shown ({@code PROJECTED}) or made ({@code ACTUAL}). */
    private static void nextStep(RawClient client, String stateType) throws IOException {
        String root = client.next("timestep-advanced");
        while (!root.contains(stateType)) {
            root = client.next("timestep-advanced");
        }
    }

    private static String push(int object, String name, double x) {
        return ("<auvsml><apply-direct-force-command world-object-id=\"%d\" name=\"%s\""
                        + " orientation=\"WORLD\"><force-vector x=\"%s\" y=\"0.0\" z=\"0.0\"/>"
                        + "</apply-direct-force-command></auvsml>")
                .formatted(object, name, x);
    }

    private static String ready(long step) {
        return "<auvsml><ready-command step=\"%d\"/></auvsml>".formatted(step);
    }

    private <T> T world(Function<World, T> question) {
        return simulator.orElseThrow().ask(question);
    }

    private double x(int object) {
        return this.<Double>world(w -> w.object(object).position().x());
    }

    @Test
    void aStepIsMadeWhenEveryMemberHasAnsweredIt() throws IOException {
        start(new LockstepTimestepper());
        RawClient a = member("a");
        RawClient b = member("b");
        a.send("<auvsml><step-command count=\"2\"/></auvsml>");
        assertThat(a.next("timestep-advanced")).contains("\"0.05\"").contains("PROJECTED");
        a.send(ready(1));
        b.next("timestep-advanced");
        b.send(ready(1));
        assertThat(b.next("timestep-advanced")).contains("\"0.05\"").contains("ACTUAL");
        assertThat(b.next("timestep-advanced")).contains("\"0.1\"").contains("PROJECTED");
    }

    @Test
    void whatIsSentBeforeTheFirstStepIsShownActsFromItOn() throws IOException {
        start(new LockstepTimestepper());
        RawClient a = member("a");
        a.send(push(1, "engine", 4) + "<auvsml><step-command/></auvsml>");
        a.next("timestep-advanced");
        a.send(push(1, "engine", 400) + ready(1));
        assertThat(a.next("timestep-advanced")).contains("ACTUAL");
        World alone = Tank.world();
        alone.object(1).applyForce(force(4));
        alone.advanceTimestep();
        assertThat(this.<Vec3>world(w -> w.object(1).position()))
                .isEqualTo(alone.object(1).position());
    }

    private static NamedForce force(double x) {
        return NamedForce.direct("engine", Frame.WORLD, new Vec3(x, 0, 0));
    }

    @Test
    void anotherStepThanTheOneThatIsOwedIsAnError() throws IOException {
        start(new LockstepTimestepper());
        RawClient a = member("a");
        assertThat(a.ask("1", "<ready-command step=\"2\"/>"))
                .contains("a has to answer step 1, not 2");
        assertThat(a.ask("3", "<ready-command step=\"1\"/>"))
                .contains("step 1 has not been shown yet");
    }

    @Test
    void whoIsNoMemberCannotAnswer() throws IOException {
        start(new LockstepTimestepper());
        RawClient stranger = RawClient.welcomed(tcp.port());
        clients.add(stranger);
        assertThat(stranger.ask("1", "<ready-command step=\"0\"/>"))
                .contains("client 1 is no member of a lock-step; say hello-command first");
        member("a");
        assertThat(stranger.ask("2", "<hello-command name=\"a\"/>"))
                .contains("the name 'a' is that of another client");
    }

    @Test
    void aNameThatTheSimulatorGivesIsThatOfItsOwnSessionAlone() throws IOException {
        start(new LockstepTimestepper());
        RawClient first = RawClient.welcomed(tcp.port());
        clients.add(first);
        assertThat(first.ask("1", "<hello-command name=\"client 2\"/>"))
                .contains("code=\"REFUSED\"")
                .contains("the name 'client 2' is one that the simulator gives; choose another");
        assertThat(first.ask("2", "<hello-command name=\"client 1\"/>"))
                .contains("<hello-response");
    }

    /** Both push the same two objects; who controls which does not depend on who comes first. */
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void whatMembersSendIsUsedInAnOrderOfItsOwn(long seed) throws IOException {
        Random random = new Random(seed);
        Simulator running = start(new LockstepTimestepper());
        RawClient a = member("a");
        RawClient b = member("b");
        List<Runnable> sending = new ArrayList<>();
        sending.add(() -> send(a, push(2, "of a", 2) + push(1, "of a", 2)));
        sending.add(() -> send(b, push(1, "of b", -8) + push(3, "of b", -8)));
        Collections.shuffle(sending, random);
        sending.forEach(Runnable::run);
        a.ask("taken", "<get-simulator-state-request/>");
        b.ask("taken", "<get-simulator-state-request/>");
        send(a, "<auvsml><step-command/></auvsml>");
        assertThat(b.next("error-response")).contains("a (127.0.0.1").contains("'Bob'");
        a.next("timestep-advanced");
        b.next("timestep-advanced");
        send(b, ready(1));
        send(a, ready(1));
        a.next("timestep-advanced");
        assertThat(List.of(x(1), x(2), x(3))).map(Math::signum).containsExactly(1.0, 1.0, -1.0);
        assertThat(running.state().step()).isEqualTo(1);
    }

    private static void send(RawClient client, String text) {
        try {
            client.send(text);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String feedback(String time, double x) {
        return ("<auvsml><different-position-feedback-message world-object-id=\"1\""
                        + " timestamp=\"%s\" handler-name=\"DirectPositionChangeFeedbackHandler\">"
                        + "<virtual-position x=\"0.0\" y=\"0.0\" z=\"0.0\"/>"
                        + "<actual-position x=\"%s\" y=\"0.0\" z=\"0.0\"/>"
                        + "<old-position x=\"0.0\" y=\"0.0\" z=\"0.0\"/>"
                        + "</different-position-feedback-message></auvsml>")
                .formatted(time, x);
    }

    @Test
    void feedbackIsAnAnswer() throws IOException {
        start(new LockstepTimestepper());
        RawClient a = member("a");
        a.send("<auvsml><step-command/></auvsml>");
        a.next("timestep-advanced");
        a.send(feedback("0.05", 0.5));
        assertThat(a.next("timestep-advanced")).contains("ACTUAL");
        assertThat(x(1)).isEqualTo(0.5);
    }

    @Test
    void whoGoesIsNotWaitedForAndWhatItHadNotFinishedIsNotDone() throws IOException {
        start(new LockstepTimestepper());
        RawClient a = member("a");
        RawClient b = member("b");
        a.send("<auvsml><step-command count=\"2\"/></auvsml>");
        a.next("timestep-advanced");
        b.next("timestep-advanced");
        a.send(ready(1));
        b.send(push(2, "of b", 8));
        b.reset();
        assertThat(a.next("timestep-advanced")).contains("ACTUAL");
        a.next("timestep-advanced");
        a.send(ready(2));
        assertThat(a.next("timestep-advanced")).contains("\"0.1\"").contains("ACTUAL");
        assertThat(x(2)).isZero();
    }

    @Test
    void whomAStepWaitsForIsListedAndCanBeDisconnected() throws IOException {
        start(new LockstepTimestepper());
        RawClient a = member("a");
        RawClient hung = member("hung");
        RawClient admin = RawClient.welcomed(tcp.port());
        clients.add(admin);
        assertThat(admin.ask("1", "<list-clients-request/>")).doesNotContain("awaited=\"1\"");
        a.send("<auvsml><step-command/></auvsml>");
        hung.next("timestep-advanced");
        a.ask("ready", "<ready-command step=\"1\"/>");
        admin.send("<auvsml request-id=\"later\"><take-snapshot-command name=\"s\"/></auvsml>");
        String listed = admin.ask("2", "<list-clients-request/>");
        assertThat(listed).containsPattern("name=\"hung\"[^>]*awaited=\"1\"");
        assertThat(listed).containsOnlyOnce("awaited=\"1\"");
        admin.send("<auvsml><disconnect-client-command client=\"hung\"/></auvsml>");
        assertThat(admin.next("command-done-response")).contains("request-id=\"later\"");
        nextStep(a, "ACTUAL");
    }

    @Test
    void whoIsLateCanBeGoneOnWithout() throws IOException {
        start(new LockstepTimestepper(Optional.of(Duration.ofMillis(200)), WhenLate.GO_ON));
        RawClient a = member("a");
        a.send("<auvsml><step-command count=\"2\"/></auvsml>");
        assertThat(a.next("lockstep-timeout"))
                .contains("step=\"1\"")
                .contains("then=\"go-on\"")
                .contains("<client name=\"a\"/>");
        assertThat(a.next("timestep-advanced")).contains("ACTUAL");
        assertThat(a.ask("1", "<ready-command step=\"1\"/>")).contains("a has to answer step 2");
        a.ask("2", "<ready-command step=\"2\"/>");
        assertThat(x(1)).isZero();
    }

    @Test
    void whoIsLateCanBeReleased() throws IOException {
        start(new LockstepTimestepper(Optional.of(Duration.ofMillis(200)), WhenLate.RELEASE));
        RawClient a = member("a");
        a.send(push(1, "engine", 4) + "<auvsml><step-command/></auvsml>");
        assertThat(a.next("lockstep-timeout")).contains("then=\"release\"");
        assertThat(a.next("timestep-advanced")).contains("ACTUAL");
        RawClient other = member("b");
        other.send(push(1, "mine now", 4) + ready(1));
        assertThat(other.ask("f", "<get-simulator-state-request/>")).contains("step=\"1\"");
        assertThat(this.<Integer>world(w -> w.object(1).forces().size())).isEqualTo(1);
    }

    @Test
    void whoIsLateCanBeWaitedForAndIsNamedEachTime() throws IOException {
        start(new LockstepTimestepper(Optional.of(Duration.ofMillis(100)), WhenLate.WAIT));
        RawClient a = member("a");
        a.send("<auvsml><step-command/></auvsml>");
        a.next("lockstep-timeout");
        assertThat(a.next("lockstep-timeout")).contains("then=\"wait\"");
        a.send(ready(1));
        assertThat(a.next("timestep-advanced")).contains("ACTUAL");
    }

    /** What a member sent at the start is still there when the first step is made again. */
    @Test
    void lateFeedbackCorrectsThePastOfALockstep() throws IOException {
        simulator =
                Optional.of(
                        Simulator.of(Tank.world())
                                .timestepper(new LockstepTimestepper())
                                .feedbackHorizon(1)
                                .rate(OptionalDouble.empty())
                                .paused()
                                .transport(tcp)
                                .start());
        RawClient a = member("a");
        a.send(push(1, "engine", 4) + "<auvsml><step-command count=\"3\"/></auvsml>");
        for (int step = 1; step <= 2; step++) {
            nextStep(a, "PROJECTED");
            a.send(ready(step));
        }
        nextStep(a, "PROJECTED");
        a.send(feedback("0.05", 7) + ready(3));
        assertThat(a.next("timestep-advanced")).contains("ACTUAL");
        send(a, "<auvsml><step-command/></auvsml>");
        assertThat(a.next("history-revised")).contains("from=\"0.0\" to=\"0.15");
        World alone = Tank.world();
        alone.object(1).applyForce(force(4));
        for (int step = 1; step <= 3; step++) {
            alone.advanceTimestep();
            if (step == 1) {
                alone.object(1).setPosition(new Vec3(7, 0, 0));
            }
        }
        nextStep(a, "PROJECTED");
        a.send(ready(4));
        nextStep(a, "ACTUAL");
        alone.advanceTimestep();
        assertThat(this.<Long>world(World::stateHash)).isEqualTo(alone.stateHash());
    }
}
