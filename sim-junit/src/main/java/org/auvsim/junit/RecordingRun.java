package org.auvsim.junit;

import static org.auvsim.junit.Figures.text;

import static java.util.Objects.requireNonNull;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.recording.Reach;
import org.auvsim.auvsml.document.recording.RecordingReader;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.server.replay.Divergence;
import org.auvsim.server.replay.Replayer;
import org.auvsim.server.simulator.Simulator;
import org.auvsim.server.simulator.SimulatorBuilder;

import java.io.IOException;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A recording that is run again with all that clients did.
 *
 * @param until world time (s) of the end; NaN: where the recording ends
 */
record RecordingRun(ReplayedFile file, double until) {
    Observed replay() throws ReplayException {
        try {
            RecordedCourse recorded = recorded();
            try (RecordingReader recording = open();
                    Replayer replayer = new Replayer(recording, simulator(recording))) {
                return replay(replayer, recording, recorded);
            }
        } catch (DocumentException e) {
            throw new ReplayException(requireNonNull(e.getMessage()), e);
        } catch (IOException | IllegalArgumentException e) {
            throw new ReplayException(
                    "%s cannot be replayed: %s".formatted(file.name(), e.getMessage()), e);
        }
    }

    private RecordingReader open() throws DocumentException {
        return RecordingReader.open(file.path(), AuvsmlMapper.load(file.loader()));
    }

    private RecordedCourse recorded() throws DocumentException, IOException {
        try (RecordingReader recording = open()) {
            return new RecordedCourse(recording);
        }
    }

    private SimulatorBuilder simulator(RecordingReader recording) {
        return Simulator.of(recording.scenario())
                .catalogue(MessageCatalogue.load(file.loader()))
                .serverName(recording.recording().server())
                .rate(/* as fast as possible */ OptionalDouble.empty());
    }

    private Observed replay(Replayer replayer, RecordingReader recording, RecordedCourse recorded)
            throws DocumentException, ReplayException {
        requireEndAfter(recording.scenario().startTime());
        requireEndWithin(recorded.reach());
        Observation observation = new Observation(replayer.world());
        boolean goesOn = true;
        while (goesOn && !isOver(replayer)) {
            goesOn = replayer.advanceTimestep();
            observation.look();
        }
        if (!isOver(replayer)) {
            requireReached(replayer, recorded.reach());
        }
        return new Observed(
                file.name(),
                /* ofRecording= */ true,
                recording.scenario(),
                replayer.world().time(),
                observation.tracks(
                        id -> recorded.find(id).map(b -> b.until(replayer.world().time()))),
                observation.encounters(),
                replayer.divergence().map(Divergence::sentence));
    }

    private void requireEndAfter(double start) throws ReplayException {
        if (until <= start) {
            throw new ReplayException(
                    "%s begins at %s s: until must be after that, but is %s s."
                            .formatted(file.name(), text(start), text(until)));
        }
    }

    private void requireEndWithin(Reach reach) throws ReplayException {
        if (until > reach.timestamp() + Trajectory.SAME_TIME) {
            throw new ReplayException(
                    "%s ends at %s s: until must not be after that, but is %s s."
                            .formatted(file.name(), text(reach.timestamp()), text(until)));
        }
    }

    private boolean isOver(Replayer replayer) {
        return replayer.world().time() >= until - Trajectory.SAME_TIME;
    }

    /** What a shorter run than the recorded one shows would prove nothing. */
    private void requireReached(Replayer replayer, Reach reach) throws ReplayException {
        if (replayer.steps() < reach.step()) {
            Optional<String> why = replayer.divergence().map(Divergence::sentence);
            throw new ReplayException(
                    "%s cannot be replayed beyond step %d of %d, %s s: %s"
                            .formatted(
                                    file.name(),
                                    replayer.steps(),
                                    reach.step(),
                                    text(replayer.world().time()),
                                    why.orElse("the next one cannot be made")));
        }
    }
}
