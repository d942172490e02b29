package org.auvsim.server.net;

import java.util.Optional;

/** Encoded bytes, shared by all who get them; with a topic if a newer message may replace them. */
final class Delivery {
    private final byte[] bytes;
    private final Optional<Topic> topic;

    private Delivery(byte[] bytes, Optional<Topic> topic) {
        this.bytes = bytes;
        this.topic = topic;
    }

    /** A response, an error, an event: never left out. */
    static Delivery control(byte[] bytes) {
        return new Delivery(bytes, Optional.empty());
    }

    /** A state: left out when the client lags and a newer one is there. */
    static Delivery state(byte[] bytes, Topic topic) {
        return new Delivery(bytes, Optional.of(topic));
    }

    byte[] bytes() {
        return bytes;
    }

    Optional<Topic> topic() {
        return topic;
    }

    boolean isControl() {
        return topic.isEmpty();
    }
}
