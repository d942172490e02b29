package org.auvsim.server.replay;

import java.util.Optional;

/**
 * Where a replay first differs from its recording.
 *
 * @param step after which it does
 * @param time the world's time (s) after that step
 * @param object name and id of the world object that differs, if it is one
 * @param what differs, as {@code position.x}
 * @param recorded what the recording has
 * @param replayed what the replay has
 */
public record Divergence(
        long step,
        double time,
        Optional<String> object,
        String what,
        String recorded,
        String replayed) {
    /** For people. */
    public String sentence() {
        return "the replay differs from the recording at step %d (%s s): %s%s was %s, but is %s now"
                .formatted(
                        step,
                        time,
                        object.map(name -> name + ": ").orElse(""),
                        what,
                        recorded,
                        replayed);
    }
}
