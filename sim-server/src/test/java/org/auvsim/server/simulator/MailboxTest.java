package org.auvsim.server.simulator;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;

@Timeout(20)
class MailboxTest {
    private final Mailbox mailbox = new Mailbox(2);
    private final List<String> done = new ArrayList<>();

    private Input task(String name) {
        return new Input.Asked(() -> done.add(name));
    }

    private static void run(List<Input> inputs) {
        for (Input input : inputs) {
            ((Input.Asked) input).question().run();
        }
    }

    @Test
    void oneIsTakenAtATimeByAStepThatWaits() throws InterruptedException {
        mailbox.post(task("1"));
        mailbox.post(task("2"));
        run(List.of(mailbox.next(0).orElseThrow()));
        assertThat(done).containsExactly("1");
        run(List.of(mailbox.next(0).orElseThrow()));
        assertThat(mailbox.next(0)).isEmpty();
        assertThat(done).containsExactly("1", "2");
    }

    @Test
    void whoBringsTooMuchWaits() throws InterruptedException, ExecutionException {
        mailbox.post(task("1"));
        mailbox.post(task("2"));
        CountDownLatch begun = new CountDownLatch(1);
        FutureTask<Boolean> third =
                new FutureTask<>(
                        () -> {
                            begun.countDown();
                            return mailbox.post(task("3"));
                        });
        Thread.ofVirtual().start(third);
        begun.await();
        assertThat(third.isDone()).isFalse();
        run(mailbox.take(2, 0));
        assertThat(third.get()).isTrue();
        run(mailbox.take(2, Long.MAX_VALUE));
        assertThat(done).containsExactly("1", "2", "3");
    }

    @Test
    void noMoreIsTakenThanAskedForAndTheRestStaysInOrder() throws InterruptedException {
        Mailbox three = new Mailbox(3);
        three.post(task("1"));
        three.post(task("2"));
        three.post(task("3"));
        run(three.take(1, 0));
        assertThat(done).containsExactly("1");
        run(three.take(2, 0));
        assertThat(done).containsExactly("1", "2", "3");
    }

    @Test
    void aClosedMailboxWakesWhoWaitsAndTakesNothing()
            throws InterruptedException, ExecutionException {
        FutureTask<List<Input>> waiting = new FutureTask<>(() -> mailbox.take(2, Long.MAX_VALUE));
        Thread.ofVirtual().start(waiting);
        mailbox.close();
        assertThat(waiting.get()).isEmpty();
        assertThat(mailbox.post(task("late"))).isFalse();
    }
}
