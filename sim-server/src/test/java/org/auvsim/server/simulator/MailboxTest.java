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

    private Runnable task(String name) {
        return () -> done.add(name);
    }

    @Test
    void feedbackIsTakenWhileRequestsWait() throws InterruptedException {
        mailbox.postRequest(task("request"));
        mailbox.postFeedback(task("feedback"));
        mailbox.takeFeedback(0).orElseThrow().run();
        assertThat(mailbox.takeFeedback(0)).isEmpty();
        mailbox.take(2, 0).forEach(Runnable::run);
        assertThat(done).containsExactly("feedback", "request");
    }

    @Test
    void whoBringsTooMuchWaits() throws InterruptedException, ExecutionException {
        mailbox.postRequest(task("1"));
        mailbox.postRequest(task("2"));
        CountDownLatch begun = new CountDownLatch(1);
        FutureTask<Boolean> third =
                new FutureTask<>(
                        () -> {
                            begun.countDown();
                            return mailbox.postRequest(task("3"));
                        });
        Thread.ofVirtual().start(third);
        begun.await();
        assertThat(third.isDone()).isFalse();
        mailbox.take(2, 0).forEach(Runnable::run);
        assertThat(third.get()).isTrue();
        mailbox.take(2, Long.MAX_VALUE).forEach(Runnable::run);
        assertThat(done).containsExactly("1", "2", "3");
    }

    @Test
    void noMoreIsTakenThanAskedForAndTheRestStaysInOrder() throws InterruptedException {
        mailbox.postRequest(task("1"));
        mailbox.postRequest(task("2"));
        mailbox.postFeedback(task("feedback"));
        mailbox.take(1, 0).forEach(Runnable::run);
        assertThat(done).containsExactly("1", "feedback");
        mailbox.take(1, 0).forEach(Runnable::run);
        assertThat(done).containsExactly("1", "feedback", "2");
    }

    @Test
    void aClosedMailboxWakesWhoWaitsAndTakesNothing()
            throws InterruptedException, ExecutionException {
        FutureTask<List<Runnable>> waiting =
                new FutureTask<>(() -> mailbox.take(2, Long.MAX_VALUE));
        Thread.ofVirtual().start(waiting);
        mailbox.close();
        assertThat(waiting.get()).isEmpty();
        assertThat(mailbox.postRequest(task("late"))).isFalse();
        assertThat(mailbox.postFeedback(task("late"))).isFalse();
    }
}
