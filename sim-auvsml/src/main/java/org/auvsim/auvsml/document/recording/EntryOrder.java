package org.auvsim.auvsml.document.recording;

import org.auvsim.auvsml.recording.Entry;
import org.auvsim.auvsml.recording.RecordedInput;
import org.auvsim.auvsml.recording.RecordingEnded;

import java.util.Optional;

/**
 * The order in which entries must stand: revisions, and steps, never go back, nor does time but
 * with a new revision; inputs of one step are counted up.
 */
final class EntryOrder {
    private int revision;
    private long step;
    private double time;
    private long inputStep;
    private int inputIndex = -1;
    private boolean ended;

    /** From the time (s) at which the scenario begins. */
    EntryOrder(double startTime) {
        time = startTime;
    }

    /** What is wrong with the place of an entry that follows those before, if anything. */
    Optional<String> fault(Entry entry) {
        if (ended) {
            return Optional.of("nothing may follow the recording's end");
        }
        if (entry.revision() < revision) {
            return goesBack("revision", entry.revision(), revision);
        }
        if (entry.step() < step) {
            return goesBack("step", entry.step(), step);
        }
        if (entry.revision() == revision && entry.timestamp() < time) {
            return goesBack("timestamp", entry.timestamp(), time);
        }
        if (entry instanceof RecordedInput input) {
            if (input.step() == inputStep && input.index() <= inputIndex) {
                return Optional.of(
                        "its index must be above %d, that of the input before, but is %d"
                                .formatted(inputIndex, input.index()));
            }
            inputStep = input.step();
            inputIndex = input.index();
        }
        revision = entry.revision();
        step = entry.step();
        time = entry.timestamp();
        ended = entry instanceof RecordingEnded;
        return Optional.empty();
    }

    private static Optional<String> goesBack(String what, Number is, Number before) {
        return Optional.of(
                "its %s must be %s or more, as in the entry before, but is %s"
                        .formatted(what, before, is));
    }
}
