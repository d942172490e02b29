package org.auvsim.server.net;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.framing.AuvsmlWriter;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.command.EventType;
import org.auvsim.auvsml.message.command.ListenedObject;
import org.auvsim.auvsml.message.command.Listener;
import org.auvsim.auvsml.message.entity.EntityRemovedMessage;
import org.junit.jupiter.api.Test;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicInteger;

class NotificationsTest {
    private final AuvsmlWriter writer =
            new AuvsmlWriter(MessageCatalogue.load(getClass().getClassLoader()));
    private final Notifications notifications = new Notifications(writer);
    private final AtomicInteger made = new AtomicInteger();

    private ClientSession client(long id, ListenedObject... objects) {
        ClientSession session = new ClientSession(id, "here", Role.ADMIN, writer);
        List.of(objects).forEach(session::register);
        notifications.add(session);
        return session;
    }

    private static ListenedObject all(String id) {
        return new ListenedObject(id, List.of(Listener.to(Listener.ALL)));
    }

    private static ListenedObject only(String id, EventType type) {
        return new ListenedObject(id, List.of(Listener.to(type.eventName())));
    }

    private void moved(long object, double time) {
        notifications.state(
                EventType.MOVEMENT_STATE_CHANGE,
                object,
                time,
                () -> {
                    made.incrementAndGet();
                    return new EntityRemovedMessage(time, object);
                });
    }

    private void stepAdvanced(double time) {
        notifications.stepAdvanced(
                EventType.MOVEMENT_STATE_CHANGE, time, () -> new EntityRemovedMessage(time, 0));
    }

    private String heard(ClientSession session) throws InterruptedException {
        notifications.flush();
        session.close();
        StringBuilder text = new StringBuilder();
        for (var bytes = session.nextBytes(); bytes.isPresent(); bytes = session.nextBytes()) {
            text.append(new String(bytes.get(), StandardCharsets.UTF_8));
        }
        return text.toString();
    }

    private static String lines(String text) {
        return text.replaceAll("<[^>]*timestamp=\"([^\"]*)\" entity-id=\"([^\"]*)\"[^>]*>", "$2@$1")
                .replaceAll("<[^>]*>", "")
                .replace('\n', ' ')
                .strip();
    }

    @Test
    void oneMessageIsMadeForAllWhoWantItAndNoneForNobody() throws InterruptedException {
        ClientSession one = client(1, all("1"));
        ClientSession other = client(2, all("*"));
        ClientSession third = client(3, all("2"));
        moved(1, 0.5);
        moved(9, 0.5);
        assertThat(made).hasValue(2);
        assertThat(lines(heard(one))).isEqualTo("1@0.5");
        assertThat(lines(heard(other))).isEqualTo("1@0.5 9@0.5");
        assertThat(lines(heard(third))).isEmpty();
        third.unregister(all("2"));
        moved(2, 1);
        notifications.remove(other);
        moved(2, 1);
        assertThat(made).hasValue(3);
    }

    @Test
    void registeringTwiceSendsOnce() throws InterruptedException {
        ClientSession client = client(1, all("1"), all("1"), all("*"));
        moved(1, 0.5);
        stepAdvanced(0.5);
        assertThat(lines(heard(client))).isEqualTo("1@0.5 0@0.5");
    }

    @Test
    void unregisteringATypeLeavesTheOthers() throws InterruptedException {
        ClientSession client = client(1, all("1"));
        client.unregister(only("1", EventType.MOVEMENT_STATE_CHANGE));
        moved(1, 0.5);
        stepAdvanced(0.5);
        assertThat(lines(heard(client))).isEqualTo("0@0.5");
    }

    @Test
    void unregisteringAllOfAnObjectLeavesOtherObjects() throws InterruptedException {
        ClientSession client = client(1, all("1"), only("2", EventType.MOVEMENT_STATE_CHANGE));
        client.unregister(all("1"));
        moved(1, 0.5);
        moved(2, 0.5);
        stepAdvanced(0.5);
        assertThat(lines(heard(client))).isEqualTo("2@0.5");
    }

    @Test
    void aMaximalRateThinsMovementsAndLetsCorrectedOnesThrough() throws InterruptedException {
        ClientSession client =
                client(
                        1,
                        new ListenedObject(
                                "1",
                                List.of(
                                        new Listener(
                                                EventType.MOVEMENT_STATE_CHANGE.eventName(),
                                                OptionalDouble.of(10)))));
        for (double time : new double[] {0.05, 0.1, 0.15000000000000002, 0.2, 0.25, 0.25, 0.3}) {
            moved(1, time);
        }
        assertThat(lines(heard(client))).isEqualTo("1@0.05 1@0.15000000000000002 1@0.25 1@0.25");
    }
}
