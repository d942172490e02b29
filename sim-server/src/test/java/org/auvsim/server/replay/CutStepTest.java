package org.auvsim.server.replay;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.recording.RecordingWriter;
import org.auvsim.auvsml.recording.Entry;
import org.auvsim.auvsml.recording.Happened;
import org.auvsim.auvsml.recording.RecordedInput;
import org.auvsim.auvsml.recording.Recording;
import org.auvsim.auvsml.recording.RecordingEnded;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.List;

/** Recordings that end while a step waits for inputs, as its program was killed then. */
class CutStepTest {
    private static final Scenario SCENARIO =
            Recorded.scenario("<lockstep-timestepper timeout='0.02' then='go-on'/>");

    private List<Entry> entries = List.of();

    /** Each step waits for a robot that says nothing, until its time is over. */
    @BeforeEach
    void record() throws Exception {
        try (RecordedSession session = new RecordedSession(SCENARIO)) {
            session.client().ask("h", "<hello-command name='robot'/>");
            for (int i = 0; i < 4; i++) {
                session.client().send("<auvsml>" + RecordedSession.pushing(i) + "</auvsml>");
                session.steps(1);
            }
            entries = Recorded.entries(session.recording());
        }
        assertThat(entries).anyMatch(CutStepTest::isInputDuringStep);
    }

    private static boolean isInputDuringStep(Entry entry) {
        return entry instanceof RecordedInput input && input.duringStep();
    }

    @Test
    void aStepOfWhichOnlyInputsAreRecordedIsNotReplayed() throws Exception {
        for (int i = 0; i < entries.size(); i++) {
            if (isInputDuringStep(entries.get(i))) {
                assertThat(stepsReplayed(entries.subList(0, i + 1)))
                        .isEqualTo(entries.get(i).step());
            }
        }
    }

    @Test
    void norIsItIfTheRecordingWasEndedThen() throws Exception {
        for (int i = 0; i < entries.size(); i++) {
            Entry last = entries.get(i);
            if (isInputDuringStep(last)) {
                List<Entry> ended = new ArrayList<>(entries.subList(0, i + 1));
                ended.add(
                        new RecordingEnded(
                                last.revision(),
                                last.step(),
                                last.timestamp(),
                                "the disk is full"));
                assertThat(stepsReplayed(ended)).isEqualTo(last.step());
            }
        }
    }

    @Test
    void aStepWhoseMovementsAreRecordedIsReplayed() throws Exception {
        for (int i = 1; i < entries.size(); i++) {
            if (entries.get(i) instanceof Happened happened) {
                assertThat(stepsReplayed(entries.subList(0, i + 1))).isEqualTo(happened.step());
            }
        }
    }

    private static long stepsReplayed(List<Entry> entries) throws Exception {
        ByteArrayOutputStream recording = new ByteArrayOutputStream();
        try (RecordingWriter writer = new RecordingWriter(recording, Recorded.MAPPER)) {
            writer.begin(new Recording(Recording.VERSION, "auvsim test", 5), SCENARIO);
            for (Entry entry : entries) {
                writer.write(entry);
            }
        }
        try (Replayer replayer = Recorded.replayer(recording.toByteArray())) {
            while (replayer.advanceTimestep()) {
                assertThat(replayer.steps()).isLessThanOrEqualTo(4);
            }
            assertThat(replayer.divergence()).isEmpty();
            assertThat(replayer.reach().step()).isEqualTo(replayer.steps());
            return replayer.steps();
        }
    }
}
