package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.SetPropulsorCommand;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

class OutboxTest {
    private final List<Message> sent = new ArrayList<>();
    private final Outbox outbox = new Outbox(sent::add);

    @Test
    void ofEachSliderTheLastPlaceIsSentOnce() {
        outbox.put("a", level("a", 0.1));
        outbox.put("b", level("b", 0.2));
        outbox.put("a", level("a", 0.3));
        assertThat(sent).isEmpty();
        outbox.send();
        outbox.send();
        assertThat(sent).containsExactly(level("a", 0.3), level("b", 0.2));
    }

    private static Message level(String name, double level) {
        return new SetPropulsorCommand(1, name, level);
    }
}
