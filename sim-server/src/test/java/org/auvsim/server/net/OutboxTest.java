package org.auvsim.server.net;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.message.command.EventType;
import org.junit.jupiter.api.Test;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

class OutboxTest {
    private static final int MOST_STATES = 4;
    private static final int MOST_CONTROL = 3;
    private static final int MOST_CONTROL_BYTES = 100_000;

    private final Outbox outbox = new Outbox(MOST_STATES, MOST_CONTROL, MOST_CONTROL_BYTES);

    private static Delivery state(long object, String text) {
        return Delivery.state(
                text.getBytes(StandardCharsets.UTF_8),
                new Topic(EventType.MOVEMENT_STATE_CHANGE, object));
    }

    private static Delivery control(String text) {
        return Delivery.control(text.getBytes(StandardCharsets.UTF_8));
    }

    /** A step: two objects move, then it is over. */
    private void offerStep(int number) {
        outbox.offer(
                List.of(state(1, "a" + number), state(2, "b" + number), state(0, "t" + number)));
    }

    private List<String> takeAll() throws InterruptedException {
        List<String> all = new ArrayList<>();
        outbox.close();
        for (Optional<Outbox.Packet> packet = outbox.take();
                packet.isPresent();
                packet = outbox.take()) {
            packet.get().messages().forEach(m -> all.add(new String(m, StandardCharsets.UTF_8)));
            if (packet.get().skipped() > 0) {
                all.add("skipped " + packet.get().skipped());
            }
        }
        return all;
    }

    @Test
    void aClientThatKeepsUpGetsEverythingInOrder() throws InterruptedException {
        offerStep(1);
        outbox.offer(List.of(control("answer")));
        assertThat(takeAll()).containsExactly("a1", "b1", "t1", "answer");
    }

    @Test
    void aClientThatLagsGetsTheNewestStatesEveryEventAndTheCount() throws InterruptedException {
        offerStep(1);
        outbox.offer(List.of(control("collision")));
        offerStep(2);
        offerStep(3);
        offerStep(4);
        assertThat(takeAll()).containsExactly("collision", "a4", "b4", "t4", "skipped 9");
    }

    @Test
    void theEndOfAStepNeverOvertakesItsMovements() throws InterruptedException {
        for (int step = 1; step <= 50; step++) {
            offerStep(step);
        }
        List<String> all = takeAll();
        assertThat(all.subList(all.size() - 4, all.size() - 1))
                .containsExactly("a50", "b50", "t50");
        assertThat(all).hasSizeLessThan(5 * MOST_STATES);
    }

    @Test
    void tooMuchControlIsRefusedAndNothingOfItIsTaken() throws InterruptedException {
        assertThat(outbox.offer(List.of(control("1"), control("2")))).isTrue();
        assertThat(outbox.offer(List.of(control("3"), control("4")))).isFalse();
        assertThat(takeAll()).containsExactly("1", "2");
    }

    @Test
    void tooManyBytesOfControlAreRefusedUntilSomeAreTaken() throws InterruptedException {
        String half = "x".repeat(MOST_CONTROL_BYTES / 2);
        assertThat(outbox.offer(List.of(control(half), control(half)))).isTrue();
        assertThat(outbox.offer(List.of(control("y")))).isFalse();
        outbox.take();
        assertThat(outbox.offer(List.of(control("y")))).isTrue();
        assertThat(outbox.offer(List.of(state(1, half + half)))).isTrue();
    }

    @Test
    void anAbortedOutboxHoldsItsLastMessageAlone() throws InterruptedException {
        offerStep(1);
        outbox.abort("farewell".getBytes(StandardCharsets.UTF_8));
        offerStep(2);
        assertThat(takeAll()).containsExactly("farewell");
    }

    @Test
    void aPacketIsBounded() throws InterruptedException {
        String long40k = "x".repeat(40_000);
        outbox.offer(List.of(control(long40k), control(long40k)));
        assertThat(outbox.take().orElseThrow().messages()).hasSize(1);
        assertThat(outbox.take().orElseThrow().messages()).hasSize(1);
    }
}
