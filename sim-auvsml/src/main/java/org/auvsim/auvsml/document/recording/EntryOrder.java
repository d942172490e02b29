package org.auvsim.auvsml.document.recording;

import org.auvsim.auvsml.recording.Entry;
import org.auvsim.auvsml.recording.Happened;
import org.auvsim.auvsml.recording.RecordedInput;
import org.auvsim.auvsml.recording.RecordingEnded;
import org.auvsim.auvsml.recording.StateHash;
import org.auvsim.auvsml.recording.StepFailed;

import java.util.Optional;

/**
 * The order in which entries must stand: steps and times never go back, but that a revision of the
 * past begins at an earlier step; inputs of one step are counted up.
 */
final class EntryOrder {
    private long step;
    private double time;
    private int revision;
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
        if (entry.step() < 0) {
            return Optional.of("its step %d is below 0".formatted(entry.step()));
        }
        ended = entry instanceof RecordingEnded;
        return switch (entry) {
            case RecordedInput input -> ofInput(input);
            case Happened happened -> ofNews(happened.revision(), happened);
            case StateHash hash -> ofNews(hash.revision(), hash);
            case StepFailed failed -> ofNews(revision, failed);
            case RecordingEnded end -> ofNews(revision, end);
        };
    }

    private Optional<String> ofInput(RecordedInput input) {
        if (input.step() == inputStep && input.index() <= inputIndex) {
            return Optional.of(
                    "its index %d must be above %d, that of the input before at this step"
                            .formatted(input.index(), inputIndex));
        }
        inputStep = input.step();
        inputIndex = input.index();
        return ofNews(revision, input);
    }

    private Optional<String> ofNews(int itsRevision, Entry entry) {
        if (itsRevision < revision) {
            return Optional.of(
                    "its revision %d is below %d, that of an entry before"
                            .formatted(itsRevision, revision));
        }
        if (itsRevision == revision && entry.step() < step) {
            return Optional.of(
                    "its step %d is below %d, that of an entry before"
                            .formatted(entry.step(), step));
        }
        if (itsRevision == revision && entry.timestamp() < time) {
            return Optional.of(
                    "its time %s s is before %s s, that of an entry before"
                            .formatted(entry.timestamp(), time));
        }
        revision = itsRevision;
        step = entry.step();
        time = entry.timestamp();
        return Optional.empty();
    }
}
