package org.auvsim.server.net;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.framing.AuvsmlWriter;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.session.DisconnectedNotification;
import org.junit.jupiter.api.Test;

import java.nio.charset.StandardCharsets;

class ClientSessionTest {
    private static final int MEBIBYTE = 1 << 20;

    private final ClientSession session =
            new ClientSession(
                    1,
                    "here",
                    Role.ADMIN,
                    new AuvsmlWriter(MessageCatalogue.load(getClass().getClassLoader())));

    private void send(int length) {
        session.send(new DisconnectedNotification("x".repeat(length)));
    }

    @Test
    void whoReadsNoneOfManyLargeMessagesIsSentAwayWithAReason() throws InterruptedException {
        for (int i = 0; i < 15; i++) {
            send(MEBIBYTE);
        }
        assertThat(session.isClosed()).isFalse();
        send(MEBIBYTE);
        assertThat(session.isClosed()).isTrue();
        send(1);
        assertThat(new String(session.nextBytes().orElseThrow(), StandardCharsets.UTF_8))
                .contains("<disconnected-notification")
                .contains("16 MiB of them, wait for this client; read them faster");
        assertThat(session.nextBytes()).isEmpty();
    }

    @Test
    void whoReadsThemStays() throws InterruptedException {
        for (int i = 0; i < 40; i++) {
            send(MEBIBYTE);
            assertThat(session.nextBytes().orElseThrow()).hasSizeGreaterThan(MEBIBYTE);
        }
        assertThat(session.isClosed()).isFalse();
    }
}
